// How the products of kinds travel through scene expressions as Values.
#pragma once

#include <vug/base/schema.h>
#include <vug/session/shot.h>

namespace vug::session {

/// The word for a product type in messages and lists.
template <class T>
struct TypeName;

template <>
struct TypeName<render::BsdfPtr> {
  static constexpr const char* value = "material";
};
template <>
struct TypeName<render::LightPtr> {
  static constexpr const char* value = "light";
};
template <>
struct TypeName<render::CameraPtr> {
  static constexpr const char* value = "camera";
};
template <>
struct TypeName<render::MediumPtr> {
  static constexpr const char* value = "medium";
};
template <>
struct TypeName<render::SamplerPtr> {
  static constexpr const char* value = "sampler";
};
template <>
struct TypeName<render::IntegratorPtr> {
  static constexpr const char* value = "integrator";
};
template <>
struct TypeName<VolumePtr> {
  static constexpr const char* value = "volume";
};
template <>
struct TypeName<MeshPtr> {
  static constexpr const char* value = "mesh";
};

/// ValueTraits of a pointer-like product: an object of exactly that type, null by default.
template <class T>
struct ObjectTraits {
  static std::string type() { return TypeName<T>::value; }
  static std::optional<T> read(const Value& v) {
    const T* object = v.object<T>();
    return object ? std::optional(*object) : std::nullopt;
  }
  static Value write(const T& object) {
    return object ? Value(Object{TypeName<T>::value, object}) : Value();
  }
};

}  // namespace vug::session

namespace vug {
template <>
struct ValueTraits<render::BsdfPtr> : session::ObjectTraits<render::BsdfPtr> {};
template <>
struct ValueTraits<render::LightPtr> : session::ObjectTraits<render::LightPtr> {};
template <>
struct ValueTraits<render::CameraPtr> : session::ObjectTraits<render::CameraPtr> {};
template <>
struct ValueTraits<render::MediumPtr> : session::ObjectTraits<render::MediumPtr> {};
template <>
struct ValueTraits<render::SamplerPtr> : session::ObjectTraits<render::SamplerPtr> {};
template <>
struct ValueTraits<render::IntegratorPtr> : session::ObjectTraits<render::IntegratorPtr> {};
template <>
struct ValueTraits<session::VolumePtr> : session::ObjectTraits<session::VolumePtr> {};
template <>
struct ValueTraits<session::MeshPtr> : session::ObjectTraits<session::MeshPtr> {};
}  // namespace vug
