#include <vug/session/places.h>

namespace vug::session {

Transform pose(const Vec3d& position, double yaw, double pitch, double roll, const Vec3d& scale) {
  return Transform::translation(position) * Transform::rotation({0, 1, 0}, yaw) *
         Transform::rotation({1, 0, 0}, pitch) * Transform::rotation({0, 0, 1}, roll) *
         Transform::scaling(scale);
}

}  // namespace vug::session

namespace vug {

std::optional<session::Places> ValueTraits<session::Places>::read(const Value& v) {
  const auto* vector = v.get<Value::Vector>();
  if (!vector) return ObjectTraits::read(v);
  const Vec3d position = vector->value;
  return std::make_shared<const session::PlacesMaker>(
      [position](session::Builder&, RandomKey key) -> std::vector<session::Place> {
        return {{Transform::translation(position), key, -1}};
      });
}

std::optional<session::Model> ValueTraits<session::Model>::read(const Value& v) {
  session::Model model;
  if (const auto* name = v.get<Value::Name>()) {
    model.name = name->text;
    return model;
  }
  if (const auto* mesh = v.object<session::MeshPtr>()) {
    model.name = (*mesh)->name;
    model.mesh = *mesh;
    return model;
  }
  const auto* given = v.object<session::Model>();
  return given ? std::optional(*given) : std::nullopt;
}

}  // namespace vug
