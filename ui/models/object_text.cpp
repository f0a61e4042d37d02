#include "ui/models/object_text.h"

#include <QCoreApplication>

#include "ui/models/said_now.h"
#include "ui/models/units.h"

namespace heft {
namespace {

struct ObjectWords {
  Q_DECLARE_TR_FUNCTIONS(ObjectText)
};

QString withSource(const NumberText& number, const QString& unit) {
  QString out = number.value;
  if (!number.plusMinus.isEmpty()) out += ' ' + number.plusMinus;
  if (!unit.isEmpty() && !number.plusMinus.endsWith(unit)) out += ' ' + unit;
  return number.source <= Source::doubted ? out : out + QStringLiteral(", ") + ObjectWords::tr("not known");
}

}  // namespace

ObjectText describeObject(const CarriedObject& carried) {
  ObjectText out;
  const ResultText numbers = describeResult(carried.object, {});
  out.findings = numbers.findings;
  for (const Finding& finding : carried.with.findings)
    if (finding.code == "picked_up" || finding.code == "put_down") {
      if (!out.note.isEmpty()) out.note += ' ';
      out.note += saidNow(finding.text);
    }
  if (numbers.withheld) {
    out.headline = numbers.answer;
    out.note = numbers.advice;
    return out;
  }
  const QString mass = numbers.mass.value + ' ' + numbers.mass.plusMinus;
  if (carried.verdict != ObjectVerdict::found) {
    out.headline = ObjectWords::tr("No object was found: %1, which noise alone could cause.").arg(mass);
    return out;
  }
  out.sure = !numbers.doubtful && carried.object.trust == Trust::good;
  out.headline =
      out.sure ? ObjectWords::tr("It weighs %1.").arg(mass) : ObjectWords::tr("It seems to weigh %1.").arg(mass);
  out.rows.push_back({ObjectWords::tr("Mass"), withSource(numbers.mass, massUnit().name), numbers.mass.tip});
  for (const NumberText& n : numbers.com)
    out.rows.push_back({ObjectWords::tr("Centre %1").arg(n.name), withSource(n, lengthUnit().name), n.tip});
  for (const NumberText& n : numbers.inertia) out.rows.push_back({n.name, withSource(n, numbers.inertiaUnit), n.tip});
  return out;
}

}  // namespace heft
