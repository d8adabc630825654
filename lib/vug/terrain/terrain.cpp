// SPDX-License-Identifier: Apache-2.0
#include <vug/terrain/terrain.h>

#include <fmt/format.h>
#include <vug/base/error.h>
#include <vug/network/survey_space.h>
#include <vug/survey/coordinate_system.h>
#include <vug/survey/system_properties.h>
#include <vug/terrain/placed_heights.h>

#include <algorithm>
#include <cmath>

namespace vug::terrain {
namespace {

/// Systems whose coordinates differ by less than this many metres are the same.
constexpr double kSame = 1e-3;

/// The largest extent in degrees of longitude that one zone of UTM represents tolerably, and the
/// latitudes between which the zones are defined.
constexpr double kWidest = 20, kSouthernmost = -80, kNorthernmost = 84;

/// Cells above and below the ground within which values are distances to first order.
constexpr double kReach = 4;

/// Cells of the file around the network that count, by those that are needed: enough that a grid
/// that is rotated by up to 39 degrees encloses the box of the network.
constexpr double kBeyond = 2;

constexpr const char* kDegrees =
    "if they are longitudes and latitudes, write system: \"EPSG:4326\"";

Error misplaced(const ElevationFile& file, const std::string& what, const std::string& hint) {
  return Error(ErrorCode::bad_input, fmt::format("the terrain '{}' {}", file.path().string(), what),
               {}, hint);
}

std::string extent(const Box3d& box) {
  return fmt::format("x {:.1f} to {:.1f}, y {:.1f} to {:.1f}", box.min.x, box.max.x, box.min.y,
                     box.max.y);
}

class Placement {
 public:
  explicit Placement(const TerrainOptions& options)
      : options_(options), file_(options.file, options.band) {}

  field::Field run() {
    choose_systems();
    const Box3d needed = stations();
    make_mapping(needed);
    choose_box(needed);
    PlacedHeights placed = place_heights(file_, mapping_, box_, options_.sampling);
    fill_holes(placed);
    require_cover(placed.box, needed);
    const TerrainSource source{ground_of(std::move(placed)), cell_, options_.around, warnings_};
    return field::Field(std::make_shared<TerrainNode>("terrain", source.traits(), source));
  }

 private:
  /// The system of the survey; empty for local metres.
  std::string survey_system() const {
    const std::string& name = options_.around->coordinate_system;
    const auto known = survey::coordinate_system(name);
    return known && known->definition.empty() ? "" : name;
  }

  void choose_systems() {
    const std::string stated = options_.system.empty() ? file_.system() : options_.system;
    std::optional<survey::SystemProperties> own;
    if (!stated.empty()) own = survey::system_properties(stated);
    if (own) from_ = own->horizontal;
    geographic_ = own && own->geographic;
    if (options_.around)
      match_survey(own);
    else if (own && (own->geographic || own->metres_per_unit != 1))
      to_ = utm_zone();
    if (!own && looks_like_degrees())
      warnings_.push_back({fmt::format("'{}' does not state its coordinate system; its coordinates "
                                       "({}) look like degrees, but are taken as metres",
                                       file_.path().string(), extent(whole_file())),
                           kDegrees});
    if (own && own->ellipsoidal) report_ellipsoid();
  }

  void match_survey(const std::optional<survey::SystemProperties>& own) {
    const std::string survey = survey_system();
    if (survey.empty() && own && own->geographic)
      throw misplaced(file_,
                      "has longitudes and latitudes, but the network around which it lies has no "
                      "coordinate system",
                      "name that of the survey in its file, e.g. with *cs in Survex");
    if (survey.empty()) {
      if (own)
        warnings_.push_back(
            {fmt::format("the network has no coordinate system; its coordinates are "
                         "taken as those of the terrain ({})",
                         own->name),
             "name the system in the survey, e.g. with *cs in Survex"});
      return;
    }
    if (!own)
      throw misplaced(
          file_, "does not state its coordinate system, but the network has one",
          looks_like_degrees()
              ? kDegrees
              : fmt::format("name it, e.g. system: \"{}\" if it is that of the network", survey));
    const survey::SystemProperties target = survey::system_properties(survey);
    if (target.geographic || target.metres_per_unit != 1)
      throw misplaced(
          file_, fmt::format("cannot be placed in '{}', whose coordinates are not metres", survey),
          "convert the survey, e.g. with *cs out UTM30N in Survex");
    to_ = survey;
    if (const auto grid = survey::missing_grid(from_, to_))
      warnings_.push_back(
          {fmt::format("PROJ lacks the grid '{}' of the best transformation from '{}' "
                       "to '{}', so the terrain may be off by several metres",
                       *grid, own->name, target.name),
           fmt::format("projsync --file {} gets it", *grid)});
  }

  Vec3d middle_of_file() const {
    return file_.transform().place(0.5 * file_.columns(), 0.5 * file_.rows());
  }

  /// In the coordinates of the file.
  Box3d whole_file() const {
    Box3d out;
    for (const double i : {0.0, 1.0})
      for (const double j : {0.0, 1.0})
        out.extendBy(file_.transform().place(i * file_.columns(), j * file_.rows()));
    return out;
  }

  /// Whether coordinates without a system are probably longitudes and latitudes.
  bool looks_like_degrees() const {
    const Box3d all = whole_file();
    const double cell = std::sqrt(std::fabs(file_.transform().determinant()));
    return all.min.x >= -360 && all.max.x <= 360 && all.min.y >= -90.1 && all.max.y <= 90.1 &&
           cell < 0.1;
  }

  std::string utm_zone() {
    const Box3d all = whole_file();
    if (geographic_ &&
        (all.size().x > kWidest || all.min.y < kSouthernmost || all.max.y > kNorthernmost))
      throw misplaced(
          file_, fmt::format("covers too much of the Earth to be flat: {} degrees", extent(all)),
          "name a network (around), or cut out a part, e.g. with gdal_translate "
          "-projwin WEST NORTH EAST SOUTH");
    const survey::Geographic place = geodesy_.geographic(from_, middle_of_file());
    const double zone = std::clamp(std::floor((place.longitude + 180) / 6) + 1, 1.0, 60.0);
    return fmt::format("UTM{:.0f}{}", zone, place.latitude < 0 ? "S" : "N");
  }

  void report_ellipsoid() {
    const auto above = survey::geoid_above_ellipsoid(geodesy_.geographic(from_, middle_of_file()));
    const std::string by = above
                               ? fmt::format(
                                     "the sea level (EGM96) is {:.1f} m above the "
                                     "ellipsoid here: raise: {:.1f}m",
                                     *above, -*above + 0.0)
                               : "PROJ has no grid of the geoid; subtract its height with 'raise'";
    if (options_.raise == 0)
      warnings_.push_back({fmt::format("the heights of '{}' are above the ellipsoid, but those of "
                                       "surveys mostly above sea level",
                                       file_.path().string()),
                           by});
  }

  /// The box of the network's stations in the plane of the survey; empty without stations.
  Box3d stations() {
    Box3d out;
    if (!options_.around) return out;
    origin_ = options_.around->origin;
    for (const network::Station& station : options_.around->stations) {
      const Vec3d p = network::to_survey(station.position) + origin_;
      lowest_ = std::min(lowest_, p.z);
      out.extendBy(Vec3d(p.x, p.y, 0));
    }
    return out;
  }

  /// Longitudes in the range of the file, which may be -180 to 180 or 0 to 360.
  Vec3d with_file_longitude(Vec3d place) const {
    if (geographic_) place.x += 360 * std::round((middle_of_file().x - place.x) / 360);
    return place;
  }

  /// Compares the systems where the terrain is needed, because projections have no values far away.
  void make_mapping(const Box3d& stations) {
    mapping_.identity = true;
    mapping_.to_survey = mapping_.to_file = [](const Vec3d& p) { return p; };
    if (to_.empty()) return;
    const auto map = [this](const std::string& a, const std::string& b, const Vec3d& p) {
      Vec3d out = geodesy_.transform(a, b, p);
      out.z = 0;
      return out;
    };
    const Mapping exact{
        [this, map](const Vec3d& p) { return map(from_, to_, p); },
        [this, map](const Vec3d& p) { return with_file_longitude(map(to_, from_, p)); }, false};
    const bool whole = stations.isEmpty();
    const Box3d box = whole ? whole_file() : with_margin(stations);
    for (const double i : {0.0, 0.5, 1.0})
      for (const double j : {0.0, 0.5, 1.0}) {
        const Vec3d p = box.min + box.size() * Vec3d(i, j, 0);
        const Vec3d other = whole ? exact.to_survey(p) : exact.to_file(p);
        mapping_.identity &= (other - p).length() < kSame;
      }
    if (!mapping_.identity) mapping_ = exact;
  }

  Box3d with_margin(const Box3d& stations) const {
    const Vec3d margin(options_.margin, options_.margin, 0);
    return {stations.min - margin, stations.max + margin};
  }

  /// Sets box_. `stations` may be empty.
  void choose_box(const Box3d& stations) {
    if (stations.isEmpty()) {
      box_ = coverage(file_, mapping_, {0, 0, file_.columns(), file_.rows()}).inside;
      if (box_.isEmpty())
        throw misplaced(file_, "has a grid that is rotated too far",
                        "name a network (around), or turn the grid with gdalwarp");
      return;
    }
    const Box3d wanted = with_margin(stations);
    const Window cells = cells_at(file_, mapping_, wanted, kBeyond);
    if (cells.columns < 2 || cells.rows < 2) throw does_not_cover(stations);
    require_one_side(wanted);
    const Coverage cover = coverage(file_, mapping_, cells);
    const Box3d inside = intersection(wanted, cover.inside);
    const bool suffices =
        !inside.isEmpty() && inside.intersects(stations.min) && inside.intersects(stations.max);
    box_ = suffices ? inside : intersection(wanted, cover.around);
    if (box_.isEmpty()) throw does_not_cover(stations);
  }

  /// Refuses networks on both sides of the meridian at which the file ends.
  void require_one_side(const Box3d& wanted) const {
    if (!geographic_) return;
    Box3d places;
    for (const double i : {0.0, 1.0})
      for (const double j : {0.0, 1.0})
        places.extendBy(mapping_.to_file(wanted.min + wanted.size() * Vec3d(i, j, 0)));
    if (places.size().x > 180)
      throw misplaced(file_, "ends at a meridian that the surroundings of the network cross",
                      "shift its longitudes, e.g. with gdalwarp -te 0 -90 360 90");
  }

  Error does_not_cover(const Box3d& stations) const {
    const auto place = [&](const std::string& system, const Box3d& box) {
      return extent(box) + (system.empty() ? "" : " of " + system);
    };
    Box3d there;
    for (const Vec3d& p : {stations.min, stations.max}) there.extendBy(mapping_.to_file(p));
    const std::string in_file =
        mapping_.identity ? "" : fmt::format(", which is {} of the file", extent(there));
    return misplaced(file_,
                     fmt::format("does not cover the network: it lies in {}, but the stations in "
                                 "{}{}",
                                 extent(whole_file()), place(to_, stations), in_file),
                     is_surveyed() ? "compare the coordinate systems and the fixed points of both"
                                   : "keep the network within the file ('from' and 'to' of karst, "
                                     "'at' of graph), or omit 'around': then the middle of the "
                                     "file is the origin of the scene");
  }

  /// Whether the network comes from a file, which has real coordinates. Other networks have those
  /// of the scene text.
  bool is_surveyed() const { return !options_.around->files.empty(); }

  void require_cover(const Box3d& cover, const Box3d& stations) const {
    if (stations.isEmpty()) return;
    const Vec3d slack(1e-6, 1e-6, 0);
    const Box3d wide(cover.min - slack, cover.max + slack);
    if (!wide.intersects(stations.min) || !wide.intersects(stations.max))
      throw does_not_cover(stations);
  }

  void fill_holes(PlacedHeights& placed) const {
    size_t holes = 0, first = 0;
    for (size_t i = placed.heights.size(); i-- > 0;)
      if (std::isnan(placed.heights[i])) {
        ++holes;
        first = i;
        if (options_.fill) placed.heights[i] = static_cast<float>(*options_.fill);
      }
    if (holes == 0 || options_.fill) return;
    const auto columns = static_cast<size_t>(placed.columns);
    const Vec3d size = placed.box.size();
    const auto column = first % columns, row = first / columns;
    const double x = placed.box.min.x + size.x * static_cast<double>(column) / (placed.columns - 1);
    const double y = placed.box.max.y - size.y * static_cast<double>(row) / (placed.rows - 1);
    throw misplaced(
        file_,
        fmt::format("has no height at {} of {} cells, first at x {:.1f}, y {:.1f}", holes,
                    placed.heights.size(), x, y),
        "give these cells a height with 'fill', use a smaller 'margin', or repair the file "
        "with gdal_fillnodata.py");
  }

  field::Ground ground_of(PlacedHeights placed) {
    const auto [low, high] = std::minmax_element(placed.heights.begin(), placed.heights.end());
    const double mean = 0.5 * (static_cast<double>(*low) + static_cast<double>(*high));
    const Vec3d middle = placed.box.center(), size = placed.box.size();
    if (!options_.around)
      origin_ =
          Vec3d(std::round(middle.x), std::round(middle.y), std::round(mean + options_.raise));
    const double shift = options_.raise - origin_.z;
    const double bottom =
        std::min(static_cast<double>(*low) + shift, lowest_ - origin_.z) - options_.base;
    for (float& height : placed.heights)
      height = static_cast<float>(static_cast<double>(height) + shift);
    cell_ = placed.cell;
    const Vec3d at = network::to_scene(middle - origin_);
    field::Ground out{field::Heightmap(placed.columns, placed.rows, std::move(placed.heights),
                                       size.x, size.y, options_.sampling),
                      Vec3d(at.x, 0, at.z), Vec3d(size.x, 0, size.y), -bottom};
    // One steep cell must not change how far noise displaces the ground everywhere.
    return with_local_slopes(std::move(out), placed.columns, placed.rows, kReach * placed.cell);
  }

  const TerrainOptions& options_;
  ElevationFile file_;
  survey::Geodesy geodesy_;
  std::string from_, to_;    ///< The systems; both are empty if the coordinates are the same.
  bool geographic_ = false;  ///< The file has longitudes and latitudes.
  Mapping mapping_;
  Vec3d origin_{0.0};
  double lowest_ = kInfinity;
  Box3d box_;
  double cell_ = 0;
  std::vector<TerrainWarning> warnings_;
};

}  // namespace

field::Field terrain(const TerrainOptions& options) { return Placement(options).run(); }

}  // namespace vug::terrain
