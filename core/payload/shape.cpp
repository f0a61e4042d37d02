#include "core/payload/shape.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/base/say.h"
#include "core/base/text.h"
#include "core/payload/kind_name.h"
#include "core/payload/mesh_volume.h"
#include "core/payload/shape_moments.h"

namespace heft {

namespace {

constexpr int kPointsPerBody = 1024;

/// Sizes between these are taken for granted on a robot's wrist [m].
constexpr double kLongTool = 2.0, kImpossible = 10.0, kTinyTool = 2e-3;

std::string lengthText(double metres) {
  return metres >= 1.0 ? heft::say("{:.3g} m", metres) : heft::say("{:.3g} mm", 1e3 * metres);
}

/// Extent along the body's own axes [m].
Vector3d extentOf(const Surface& surface) {
  Eigen::Array3d low = surface.vertices.front(), high = low;
  for (const Vector3d& v : surface.vertices) {
    low = low.min(v.array());
    high = high.max(v.array());
  }
  return high - low;
}

/// Which unit would make the mesh as large as a tool; empty if none.
std::string betterUnit(double length, double unit) {
  const auto fits = [&](double other) { return length / unit * other > 0.01 && length / unit * other < kLongTool; };
  if (unit != 0.001 && fits(0.001)) return "mm";
  if (unit != 1.0 && fits(1.0)) return "m";
  if (unit != 0.01 && fits(0.01)) return "cm";
  return {};
}

/// Adds findings about a size that is unlikely; the error if it is impossible.
std::optional<Error> checkSize(const ShapeBody& body, double length, Findings& findings, const std::string& name) {
  if (length <= kLongTool && length >= kTinyTool) return std::nullopt;
  std::string remedy;
  if (body.kind == BodyKind::mesh) {
    const std::string unit = betterUnit(length, body.unit);
    if (unit == "mm")
      remedy = heft::say("If the file is in millimetres set unit to mm.");
    else
      remedy = unit.empty()  ? heft::say("Check the unit of the file.")
               : unit == "m" ? heft::say("If the file is in metres set unit to m.")
                             : heft::say("If the file is in centimetres set unit to cm.");
  } else {
    remedy = heft::say("Dimensions are in metres.");
  }
  const std::string text = heft::say("{} is {} long.", name, lengthText(length));
  if (length > kImpossible) return Error{text + " " + remedy};
  findings.push_back({Severity::warning, "shape_size", text, remedy, {displayName(body.file), 0, 0}});
  return std::nullopt;
}

void reportRepairs(const SurfaceReport& report, const Location& where, const std::string& name, Findings& findings) {
  const auto add = [&](Severity severity, const char* code, std::string text, std::string remedy) {
    findings.push_back({severity, code, std::move(text), std::move(remedy), where});
  };
  if (report.turnedTriangles > 0)
    add(Severity::warning, "mesh_orientation",
        heft::say("{}: {} triangles faced the opposite way to their neighbours and were flipped.", name,
                  report.turnedTriangles),
        heft::say("Recompute the normals in the program that wrote the mesh."));
  if (report.turnedBodies > 0)
    add(Severity::warning, "mesh_inside_out",
        heft::say("{} is inside-out ({} of {} closed pieces); it was flipped.", name, report.turnedBodies,
                  report.bodies),
        heft::say("Flip the normals in the program that wrote the mesh if this is not wanted."));
  if (report.openEdges > 0)
    add(Severity::warning, "mesh_open",
        heft::say("{} is not closed: {} open edges; the holes were covered ({:.1f} % of the surface).", name,
                  report.openEdges, 100.0 * report.holeArea / (report.area + report.holeArea)),
        heft::say("Export a closed solid, or give a wall thickness if the tool is a thin shell."));
  if (report.sharedEdges > 0)
    add(Severity::info, "mesh_non_manifold",
        heft::say("{}: {} edges belong to more than two triangles (parts that touch along an edge).", name,
                  report.sharedEdges),
        {});
}

/// Few pieces with most of the volume; each small one (a screw, a sliver) joins the piece whose box is nearest.
std::vector<Surface> mainPieces(std::vector<Surface> pieces, double total) {
  constexpr double kLeastShare = 0.005;
  constexpr std::size_t kMost = 24;
  std::vector<std::pair<double, std::size_t>> order;
  for (std::size_t i = 0; i < pieces.size(); ++i) order.emplace_back(-volumeMoments(pieces[i])(3, 3), i);
  std::sort(order.begin(), order.end());
  std::vector<Surface> result;
  std::vector<Eigen::AlignedBox3d> boxes;
  for (const auto& [negativeVolume, i] : order) {
    Eigen::AlignedBox3d box;
    for (const Vector3d& v : pieces[i].vertices) box.extend(v);
    if (result.empty() || (-negativeVolume >= kLeastShare * total && result.size() < kMost)) {
      result.push_back(std::move(pieces[i]));
      boxes.push_back(box);
      continue;
    }
    std::size_t nearest = 0;
    for (std::size_t k = 1; k < result.size(); ++k) {
      const double difference =
          boxes[k].squaredExteriorDistance(box.center()) - boxes[nearest].squaredExteriorDistance(box.center());
      if (difference < 0.0 || (difference == 0.0 && boxes[k].volume() < boxes[nearest].volume())) nearest = k;
    }
    append(result[nearest], pieces[i]);
  }
  return result;
}

/// Points of each piece in proportion to its volume; nothing if the pieces have no inside.
std::optional<BodySamples> samplePieces(const std::vector<Surface>& pieces, const Matrix4d& moments) {
  constexpr int kLeastPoints = 24;  // of a piece
  const int pieceCount = static_cast<int>(pieces.size());
  BodySamples result;
  result.volume = moments(3, 3);
  result.unitPseudoInertia = moments / moments(3, 3);
  WeightedPoints all{Eigen::Matrix3Xd(3, 0), VectorXd(0)};
  double reached = 0.0;
  for (int i = 0; i < pieceCount; ++i) {
    const Surface& piece = pieces[static_cast<std::size_t>(i)];
    const Matrix4d own = volumeMoments(piece);
    if (!(own(3, 3) > 0.0)) continue;
    const double share = own(3, 3) / moments(3, 3);
    const WeightedPoints fine = volumePoints(piece, own, std::max(2000.0, 12000.0 * share));
    if (fine.points.cols() < 8) continue;
    reached += fine.weights.sum();
    const int spare = std::max(0, kPointsPerBody - kLeastPoints * pieceCount);
    WeightedPoints few = thinned(fine, kLeastPoints + static_cast<int>(std::lround(share * spare)));
    matchMoments(few, own / own(3, 3));  // where it cannot, the whole is matched below
    const Eigen::Index before = all.points.cols(), added = few.points.cols();
    all.points.conservativeResize(3, before + added);
    all.points.rightCols(added) = few.points;
    all.weights.conservativeResize(before + added);
    all.weights.tail(added) = few.weights * share;
    result.piece.conservativeResize(before + added);
    result.piece.tail(added).setConstant(i);
  }
  if (reached < 0.5 * moments(3, 3) || !matchMoments(all, result.unitPseudoInertia)) return std::nullopt;
  result.points = std::move(all.points);
  result.weights = std::move(all.weights);
  return result;
}

Result<BodySamples> sampleSheet(const Surface& surface, double thickness, const std::string& name) {
  const Matrix4d moments = sheetMoments(surface, thickness);
  if (!(moments(3, 3) > 0.0)) return Error{heft::say("{} has no area: all of its triangles are lines.", name)};
  BodySamples result;
  result.volume = moments(3, 3);
  result.unitPseudoInertia = moments / moments(3, 3);
  WeightedPoints few = thinned(sheetPoints(surface, thickness), kPointsPerBody);
  if (!matchMoments(few, result.unitPseudoInertia)) return Error{heft::say("{} is too thin to have a volume.", name)};
  result.piece = Eigen::VectorXi::Zero(few.points.cols());
  result.points = std::move(few.points);
  result.weights = std::move(few.weights);
  return result;
}

Result<BodySamples> sampleMesh(const ShapeBody& body, const std::string& name, Findings& findings) {
  std::shared_ptr<const Mesh> mesh = body.mesh;
  if (!mesh) {
    auto loaded = loadMesh(body.file);
    if (!loaded) return loaded.error();
    mesh = std::make_shared<const Mesh>(std::move(*loaded));
  }
  const Location where{displayName(body.file), 0, 0};
  long dropped = 0;
  Surface surface = weld(*mesh, body.unit, &dropped);
  if (dropped > 0)
    findings.push_back({Severity::warning, "mesh_bad_triangles",
                        heft::say("{}: {} triangles have a vertex that is missing or not a number.", name, dropped),
                        heft::say("They were left out."), where});
  if (surface.triangles.empty()) return Error{heft::say("{} has no triangles: a shape needs a surface.", name)};
  if (auto error = checkSize(body, extentOf(surface).maxCoeff(), findings, name)) return *error;

  if (body.wall) return sampleSheet(surface, *body.wall, name);

  const double size = extentOf(surface).maxCoeff();
  const double box = std::max(extentOf(surface).prod(), 1e-12 * size * size * size);
  ClosedPieces closed = closePieces(std::move(surface));
  const SurfaceReport& report = closed.report;
  Surface whole;
  for (const Surface& piece : closed.pieces) append(whole, piece);
  const Matrix4d moments = volumeMoments(whole);
  if (!(moments(3, 3) > 1e-6 * box) || report.holeArea > 0.4 * (report.area + report.holeArea))
    return Error{
        heft::say("{} encloses no volume ({} open edges): export a closed solid, or give its wall thickness so "
                  "that it counts as a thin shell.",
                  name, report.openEdges)};
  reportRepairs(report, where, name, findings);
  if (const double overlap = overlapShare(whole, moments); overlap > 0.02)
    findings.push_back(
        {Severity::info,
         "mesh_overlap",
         heft::say("{}: {:.0f} % of the volume is counted twice because parts overlap.", name, 100.0 * overlap),
         {},
         where});
  auto result = samplePieces(mainPieces(std::move(closed.pieces), moments(3, 3)), moments);
  if (!result)
    return Error{
        heft::say("{} is so flat, or cuts through itself so badly, that its inside cannot be determined: export a "
                  "clean solid, or give its wall thickness.",
                  name)};
  return *result;
}

Result<BodySamples> samplePrimitive(const ShapeBody& body, const std::string& name, Findings& findings) {
  double length = 0.0;
  for (const double d : body.dims) length = std::max(length, d);
  if (auto error = checkSize(body, length, findings, name)) return *error;
  const Matrix4d moments = primitiveMoments(body);
  WeightedPoints few = thinned(primitivePoints(body), kPointsPerBody);
  BodySamples result;
  result.volume = moments(3, 3);
  result.unitPseudoInertia = moments / moments(3, 3);
  if (!(result.volume > 0.0) || few.points.cols() < 4 || !matchMoments(few, result.unitPseudoInertia))
    return Error{heft::say("{} is too thin to have a volume.", name)};
  result.piece = Eigen::VectorXi::Zero(few.points.cols());
  result.points = std::move(few.points);
  result.weights = std::move(few.weights);
  return result;
}

}  // namespace

Result<std::vector<BodySamples>> sampleShape(const Shape& shape, Findings& findings) {
  if (const std::string why = whyInvalid(shape); !why.empty()) return Error{why};
  std::vector<BodySamples> result;
  for (std::size_t i = 0; i < shape.bodies.size(); ++i) {
    const ShapeBody& body = shape.bodies[i];
    const std::string name = body.kind == BodyKind::mesh && !body.file.empty()
                                 ? heft::say("The mesh {}", displayName(body.file.filename()))
                             : shape.bodies.size() > 1 ? heft::say("The {} (body {})", kindName(body.kind), i + 1)
                                                       : heft::say("The {}", kindName(body.kind));
    auto samples =
        body.kind == BodyKind::mesh ? sampleMesh(body, name, findings) : samplePrimitive(body, name, findings);
    if (!samples) return samples.error();
    samples->points = body.X_SB * samples->points;
    samples->unitPseudoInertia = body.X_SB.matrix() * samples->unitPseudoInertia * body.X_SB.matrix().transpose();
    samples->mass = body.mass;
    if (body.density) {
      samples->mass = *body.density * samples->volume;
      if (*body.density < 20.0 || *body.density > 25000.0)
        findings.push_back(
            {Severity::warning,
             "shape_density",
             heft::say("{} has a density of {:.4g} kg/m3.", name, *body.density),
             *body.density < 20.0 ? heft::say("If it is in g/cm3, multiply it by 1000.") : heft::say("Check it."),
             {}});
    }
    result.push_back(std::move(*samples));
  }
  double mass = 0.0;
  for (const BodySamples& body : result) mass += body.mass.value_or(0.0);
  if (shape.totalMass && mass > 1.05 * *shape.totalMass)
    return Error{heft::say("The bodies with a known mass or density weigh {:.4g} kg, more than the total of {:.4g} kg.",
                           mass, *shape.totalMass)};
  return result;
}

}  // namespace heft
