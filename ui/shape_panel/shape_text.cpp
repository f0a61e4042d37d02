#include "ui/shape_panel/shape_text.h"

#include <QCoreApplication>
#include <QFileInfo>
#include <QLocale>
#include <QRegularExpression>
#include <algorithm>
#include <cmath>

#include "ui/models/numbers.h"

#include "core/math/degrees.h"

namespace heft {
namespace {

struct ShapeText {
  Q_DECLARE_TR_FUNCTIONS(ShapeText)
};

Error wrong(const QString& sentence) { return Error{sentence.toStdString()}; }

QString sizes(const ShapeBody& body) {
  QStringList parts;
  for (const Measure& measure : measuresOf(body)) {
    const QString number = millimetres(measure.value);
    parts << number.left(number.size() - 3);
  }
  return ShapeText::tr("%1 mm").arg(parts.join(QString::fromUtf8(" × ")));
}

/// "60x40x120" in metres.
std::optional<std::vector<double>> lengthsFrom(const QString& text) {
  std::vector<double> out;
  for (const QString& part : text.split('x')) {
    bool ok = false;
    const double value = part.toDouble(&ok);
    if (!ok) return std::nullopt;
    out.push_back(1e-3 * value);
  }
  return out;
}

/// A body with all of its measures set.
Result<ShapeBody> measured(BodyKind kind, const std::vector<double>& lengths) {
  ShapeBody body = sketch(*toolPictureFromString(toString(kind))).front();
  const std::size_t count = measuresOf(body).size();
  if (lengths.size() != count) {
    QStringList names;
    for (const Measure& measure : measuresOf(body)) names << lengthName(measure.length);
    return wrong(ShapeText::tr("%1 needs %2 in mm, separated by x.")
                     .arg(pictureName(*toolPictureFromString(toString(kind))), names.join(", ")));
  }
  // Twice: a hole cannot be set before its tube is wide enough.
  for (int round = 0; round < 2; ++round)
    for (std::size_t m = 0; m < count; ++m) body = resized(body, m, lengths[m], measuresOf(body)[m].axis == 2 ? -1 : 0);
  return body;
}

}  // namespace

QString pictureName(ToolPicture picture) {
  switch (picture) {
    case ToolPicture::box:
      return ShapeText::tr("Box");
    case ToolPicture::cylinder:
      return ShapeText::tr("Cylinder");
    case ToolPicture::tube:
      return ShapeText::tr("Tube");
    case ToolPicture::sphere:
      return ShapeText::tr("Sphere");
    case ToolPicture::cone:
      return ShapeText::tr("Cone");
    case ToolPicture::capsule:
      return ShapeText::tr("Capsule");
    case ToolPicture::plate:
      return ShapeText::tr("Plate");
    case ToolPicture::gripper:
      return ShapeText::tr("Gripper");
    case ToolPicture::several:
      return ShapeText::tr("Assembly");
    case ToolPicture::mesh:
      return ShapeText::tr("CAD mesh");
  }
  return {};
}

QString lengthName(Length length) {
  switch (length) {
    case Length::width:
      return ShapeText::tr("width");
    case Length::depth:
      return ShapeText::tr("depth");
    case Length::height:
      return ShapeText::tr("height");
    case Length::thickness:
      return ShapeText::tr("thickness");
    case Length::diameter:
      return ShapeText::tr("diameter");
    case Length::outerDiameter:
      return ShapeText::tr("outer");
    case Length::innerDiameter:
      return ShapeText::tr("inner");
    case Length::wholeLength:
      return ShapeText::tr("length");
  }
  return {};
}

QString millimetres(double metres) {
  const double mm = std::round(metres * 1e4) / 10;
  return ShapeText::tr("%1 mm").arg(numberText(mm, std::abs(mm - std::round(mm)) < 0.05 ? 0 : 1));
}

QString kilograms(double mass) { return ShapeText::tr("%1 kg").arg(numberText(mass, mass < 10 ? 3 : 2)); }

QString tipForMove(int axis) {
  return axis < 0 ? ShapeText::tr("Move the tool freely")
                  : ShapeText::tr("Move the tool along %1").arg(QString(QChar("xyz"[axis])));
}
QString tipForTurn(int axis) { return ShapeText::tr("Tilt the tool about %1").arg(QString(QChar("xyz"[axis]))); }
QString tipForBody(int index) { return ShapeText::tr("Choose part %1").arg(index + 1); }

QString bodyTitle(const ShapeBody& body) {
  if (body.kind == BodyKind::mesh) return QFileInfo(QString::fromStdString(body.file.string())).fileName();
  return ShapeText::tr("%1, %2").arg(pictureName(*toolPictureFromString(toString(body.kind))), sizes(body));
}

ToolPicture pictureOf(const ShapeChoice& choice) {
  if (const auto picked = toolPictureFromString(choice.picture)) {
    // Only if it can be true of these bodies: a session may come from elsewhere.
    const auto kind = bodyKindOf(*picked);
    const std::size_t count = choice.shape.bodies.size();
    const bool fits = kind                              ? count == 1 && choice.shape.bodies[0].kind == *kind
                      : *picked == ToolPicture::gripper ? count == 2
                      : *picked == ToolPicture::mesh    ? count == 1 && choice.shape.bodies[0].kind == BodyKind::mesh
                                                        : true;
    if (fits) return *picked;
  }
  return pictureOf(choice.shape);
}

QString shapeLine(const ShapeChoice& choice) {
  switch (choice.answer) {
    case ShapeChoice::Answer::notGiven:
      return ShapeText::tr("not specified");
    case ShapeChoice::Answer::unknown:
      return ShapeText::tr("none (motion only)");
    case ShapeChoice::Answer::given:
      break;
  }
  switch (pictureOf(choice)) {
    case ToolPicture::gripper:
      return ShapeText::tr("gripper-like, 2 boxes");
    case ToolPicture::several:
      return ShapeText::tr("%n part(s)", "", static_cast<int>(choice.shape.bodies.size()));
    default:
      return choice.shape.bodies.empty() ? QString() : bodyTitle(choice.shape.bodies.front());
  }
}

QString certaintyNote(Certainty certainty, bool mesh) {
  switch (certainty) {
    case Certainty::rough:
      return mesh ? ShapeText::tr(
                        "Rough: the drawing is right to about 10 %, and the material may differ from part to part.")
                  : ShapeText::tr("Rough: within about 20 % (by eye).");
    case Certainty::good:
      return mesh ? ShapeText::tr("Good: CAD of this tool, within about 2 %.")
                  : ShapeText::tr("Good: each length is right to about 4 %, like a ruler reading.");
    case Certainty::exact:
      return ShapeText::tr("Exact: from drawings, uniform material.");
  }
  return {};
}

const std::vector<Material>& materials() {
  static std::vector<Material> all;
  // Again on every call: the language may have changed.
  all = {{"steel", ShapeText::tr("Steel"), 7850},
         {"aluminium", ShapeText::tr("Aluminium"), 2700},
         {"plastic", ShapeText::tr("Plastic"), 1150},
         {"wood", ShapeText::tr("Wood"), 650}};
  return all;
}

int materialOf(double density) {
  const auto& all = materials();
  for (std::size_t i = 0; i < all.size(); ++i)
    if (std::abs(all[i].density - density) < 0.5) return static_cast<int>(i);
  return -1;
}

std::optional<double> parseWeight(const QString& text, bool grams) {
  static const QRegularExpression form(QStringLiteral("^\\s*(\\d+(?:[.,]\\d*)?|[.,]\\d+)\\s*(kg|g)?\\s*$"),
                                       QRegularExpression::CaseInsensitiveOption);
  const auto match = form.match(text);
  if (!match.hasMatch()) return std::nullopt;
  const double value = match.captured(1).replace(',', '.').toDouble();
  const QString unit = match.captured(2).toLower();
  const double mass = (unit.isEmpty() ? grams : unit == "g") ? 1e-3 * value : value;
  if (!(mass > 0) || mass > 1000) return std::nullopt;
  return mass;
}

QString shapeProblem(const Shape& shape) {
  double known = 0.0;
  QString heavy;
  for (const ShapeBody& body : shape.bodies) {
    if (body.kind == BodyKind::tube && body.dims.size() == 3 && body.dims[1] >= body.dims[0])
      return ShapeText::tr("The inner diameter must be smaller than the outer one, %1.")
          .arg(millimetres(2 * body.dims[0]));
    if (body.wall && body.kind != BodyKind::mesh) {
      const auto limit = wallLimit(body);
      if (limit && *body.wall >= *limit)
        return ShapeText::tr("A wall of %1 is too thick for this size: it must be thinner than %2.")
            .arg(millimetres(*body.wall), millimetres(*limit));
    }
    if (body.mass) known += *body.mass;
    const auto volume = body.density ? materialVolume(body) : std::nullopt;
    if (volume) {
      known += *volume * *body.density;
      const int material = materialOf(*body.density);
      heavy = material >= 0 ? materials()[static_cast<std::size_t>(material)].name : ShapeText::tr("this material");
    }
  }
  if (shape.totalMass && known > 1.02 * *shape.totalMass) {
    return heavy.isEmpty() ? ShapeText::tr("The parts together weigh %1, more than the whole tool (%2).")
                                 .arg(kilograms(known), kilograms(*shape.totalMass))
                           : ShapeText::tr(
                                 "In %1 it would weigh %2, more than the scale shows (%3): make it hollow, or choose "
                                 "another material.")
                                 .arg(heavy, kilograms(known), kilograms(*shape.totalMass));
  }
  const std::string why = whyInvalid(shape);
  return QString::fromStdString(why);
}

namespace {

/// What follows the picture and its sizes, from word `i`: place, wall, weight, material, certainty.
Result<bool> takeProperties(const QStringList& words, int i, ShapeChoice& next) {
  for (; i < words.size(); ++i) {
    if (const auto certainty = certaintyFromString(words[i].toStdString())) {
      next.shape.certainty = *certainty;
    } else if (words[i] == "at" && i + 1 < words.size()) {
      std::vector<double> pose;
      for (const QString& part : words[++i].split(',')) {
        bool ok = false;
        pose.push_back(part.toDouble(&ok));
        if (!ok) pose.clear();
        if (!ok) break;
      }
      if (pose.size() != 3 && pose.size() != 6)
        return wrong(ShapeText::tr("“at” expects x,y,z in mm, or with roll, pitch and yaw in degrees: at 0,0,60"));
      const Vector3d xyz = 1e-3 * Vector3d(pose[0], pose[1], pose[2]);
      const Vector3d rpy =
          pose.size() == 6 ? Vector3d(kRadPerDegree * Vector3d(pose[3], pose[4], pose[5])) : Vector3d::Zero();
      const Isometry3d to = poseFromXyzRpy(xyz, rpy), from = next.shape.bodies.front().X_SB;
      // The first body stands there, the others as they do beside it.
      for (ShapeBody& body : next.shape.bodies) body.X_SB = to * from.inverse() * body.X_SB;
    } else if ((words[i] == "wall" || words[i] == "weighs") && i + 1 < words.size()) {
      const bool wall = words[i] == "wall";
      bool ok = false;
      const double value = words[++i].toDouble(&ok);
      if (!ok) return wrong(ShapeText::tr("“%1” expects a number.").arg(words[i - 1]));
      if (wall)
        for (ShapeBody& body : next.shape.bodies) body.wall = 1e-3 * value;
      else
        next.shape.totalMass = value;
    } else if (words[i] == "of" && i + 1 < words.size()) {
      ++i;
      const auto& all = materials();
      const auto found = std::find_if(all.begin(), all.end(), [&](const Material& m) { return m.id == words[i]; });
      if (found == all.end()) return wrong(ShapeText::tr("“of” expects steel, aluminium, plastic or wood."));
      for (ShapeBody& body : next.shape.bodies) body.density = found->density;
    } else {
      return wrong(ShapeText::tr("“%1” is not understood after shape; see heft-studio --help.").arg(words[i]));
    }
  }
  return true;
}

}  // namespace

Result<ShapeChoice> shapeFromWords(const QStringList& words, const ShapeChoice& now) {
  const auto picture = toolPictureFromString(words.value(0).toStdString());
  if (!picture)
    return wrong(
        ShapeText::tr("shape expects box, cylinder, tube, sphere, cone, capsule, plate, gripper, several, mesh or "
                      "unknown, not “%1”.")
            .arg(words.value(0)));
  ShapeChoice next = now;
  next.answer = ShapeChoice::Answer::given;
  next.picture = words[0].toStdString();
  int i = 1;
  if (*picture == ToolPicture::mesh) {
    if (words.size() < 2) return wrong(ShapeText::tr("shape mesh expects a file: shape mesh tool.stl mm"));
    ShapeBody body;
    body.kind = BodyKind::mesh;
    body.file = QFileInfo(words[1]).absoluteFilePath().toStdString();
    body.unit = 0.0;  // To be guessed once the file is read.
    i = 2;
    const std::pair<const char*, double> units[] = {{"mm", 0.001}, {"cm", 0.01}, {"m", 1.0}, {"in", 0.0254}};
    for (const auto& [name, metres] : units) {
      if (words.value(i) != QLatin1String(name)) continue;
      body.unit = metres;
      ++i;
      break;
    }
    next.shape.bodies = {body};
  } else {
    next.shape.bodies = sketch(*picture);
    for (std::size_t b = 0; i < words.size() && words[i].contains(QRegularExpression("^[\\d.]+(x[\\d.]+)*$"));
         ++i, ++b) {
      const auto lengths = lengthsFrom(words[i]);
      if (!lengths || b >= next.shape.bodies.size())
        return wrong(ShapeText::tr("“%1” is not a valid size: give lengths in mm, separated by x.").arg(words[i]));
      auto body = measured(next.shape.bodies[b].kind, *lengths);
      if (!body) return body.error();
      if (b > 0) {
        const double from =
            extentOf(next.shape.bodies[b - 1]).max().z() + next.shape.bodies[b - 1].X_SB.translation().z();
        body->X_SB.translation().z() = from - extentOf(*body).min().z();
      }
      next.shape.bodies[b] = *body;
    }
  }
  if (auto said = takeProperties(words, i, next); !said) return said.error();
  if (*picture != ToolPicture::mesh) {
    if (const QString why = shapeProblem(next.shape); !why.isEmpty()) return wrong(why);
  }
  return next;
}

}  // namespace heft
