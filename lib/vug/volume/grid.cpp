// SPDX-License-Identifier: Apache-2.0
#include <vug/volume/grid.h>
#include <vug/volume/grid_access.h>
#include <vug/volume/openvdb_values.h>

#include <log4cplus/logger.h>

#include <mutex>
#include <optional>

namespace vug::volume {
namespace {

openvdb::GridBase::Ptr shallow_copy(const openvdb::GridBase& grid) {
  // Copies the metadata and shares the tree, which is immutable from here on.
  return openvdb::ConstPtrCast<openvdb::GridBase>(grid.copyGrid());
}

Vec3i vec(const openvdb::Coord& c) { return {c.x(), c.y(), c.z()}; }
Vec3d vec(const openvdb::Vec3d& v) { return {v.x(), v.y(), v.z()}; }

std::optional<MetaValue> read_meta(const openvdb::Metadata& meta) {
  if (const auto* b = dynamic_cast<const openvdb::BoolMetadata*>(&meta)) return b->value();
  if (const auto* i = dynamic_cast<const openvdb::Int32Metadata*>(&meta))
    return static_cast<int64_t>(i->value());
  if (const auto* i = dynamic_cast<const openvdb::Int64Metadata*>(&meta))
    return static_cast<int64_t>(i->value());
  if (const auto* f = dynamic_cast<const openvdb::FloatMetadata*>(&meta))
    return static_cast<double>(f->value());
  if (const auto* d = dynamic_cast<const openvdb::DoubleMetadata*>(&meta)) return d->value();
  if (const auto* s = dynamic_cast<const openvdb::StringMetadata*>(&meta)) return s->value();
  return MetaValue(meta.str());  // Vectors and other types as text.
}

void insert_meta(openvdb::MetaMap& map, const std::string& name, const MetaValue& value) {
  map.removeMeta(name);  // The type may change.
  if (const bool* b = std::get_if<bool>(&value)) map.insertMeta(name, openvdb::BoolMetadata(*b));
  if (const int64_t* i = std::get_if<int64_t>(&value))
    map.insertMeta(name, openvdb::Int64Metadata(*i));
  if (const double* d = std::get_if<double>(&value))
    map.insertMeta(name, openvdb::DoubleMetadata(*d));
  if (const std::string* s = std::get_if<std::string>(&value))
    map.insertMeta(name, openvdb::StringMetadata(*s));
}

}  // namespace

void initialise_openvdb() {
  static std::once_flag once;
  std::call_once(once, [] {
    openvdb::initialize();
    // Its warnings would appear among the results on standard output.
    log4cplus::Logger::getInstance(LOG4CPLUS_TEXT("openvdb")).setLogLevel(log4cplus::OFF_LOG_LEVEL);
  });
}

Grid wrap(std::shared_ptr<const openvdb::GridBase> grid) {
  return Grid(std::make_shared<const Grid::Data>(Grid::Data{std::move(grid)}));
}

Metadata read_metadata(const openvdb::MetaMap& map) {
  Metadata out;
  for (auto it = map.beginMeta(); it != map.endMeta(); ++it)
    if (it->second) out[it->first] = *read_meta(*it->second);
  return out;
}

void write_metadata(openvdb::MetaMap& map, const Metadata& metadata) {
  for (const auto& [name, value] : metadata) insert_meta(map, name, value);
}

std::string to_string(GridClass grid_class) {
  switch (grid_class) {
    case GridClass::level_set:
      return "level set";
    case GridClass::fog:
      return "fog volume";
    case GridClass::staggered:
      return "staggered";
    case GridClass::unknown:
      break;
  }
  return "unknown";
}

std::string Grid::name() const { return data_->grid->getName(); }

GridClass Grid::grid_class() const {
  switch (data_->grid->getGridClass()) {
    case openvdb::GRID_LEVEL_SET:
      return GridClass::level_set;
    case openvdb::GRID_FOG_VOLUME:
      return GridClass::fog;
    case openvdb::GRID_STAGGERED:
      return GridClass::staggered;
    case openvdb::GRID_UNKNOWN:
      break;
  }
  return GridClass::unknown;
}

std::string Grid::value_type() const { return data_->grid->valueType(); }
Vec3d Grid::voxel_size() const { return vec(data_->grid->voxelSize()); }
bool Grid::saved_as_half() const { return data_->grid->saveFloatAsHalf(); }
Metadata Grid::metadata() const { return read_metadata(*data_->grid); }

Statistics Grid::statistics() const {
  const openvdb::GridBase& grid = *data_->grid;
  Statistics out;
  out.active_voxels = grid.activeVoxelCount();
  out.leaves = grid.baseTree().leafCount();
  out.memory_bytes = grid.memUsage();
  if (out.active_voxels == 0) return out;
  const openvdb::CoordBBox box = grid.evalActiveVoxelBoundingBox();
  out.index_min = vec(box.min());
  out.index_max = vec(box.max());
  for (int corner = 0; corner < 8; ++corner) {
    const openvdb::Vec3d index((corner & 1 ? box.max() : box.min()).x(),
                               (corner & 2 ? box.max() : box.min()).y(),
                               (corner & 4 ? box.max() : box.min()).z());
    out.bounds.extendBy(vec(grid.indexToWorld(index)));
  }
  return out;
}

Grid Grid::named(const std::string& name) const {
  const openvdb::GridBase::Ptr copy = shallow_copy(*data_->grid);
  copy->setName(name);
  return wrap(copy);
}

Grid Grid::with(const Metadata& metadata) const {
  const openvdb::GridBase::Ptr copy = shallow_copy(*data_->grid);
  write_metadata(*copy, metadata);
  return wrap(copy);
}

Grid Grid::stored_as_half(bool half) const {
  const openvdb::GridBase::Ptr copy = shallow_copy(*data_->grid);
  copy->setSaveFloatAsHalf(half);
  return wrap(copy);
}

}  // namespace vug::volume
