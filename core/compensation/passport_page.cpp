#include "core/compensation/passport_page.h"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "core/base/markup.h"
#include "core/base/numbers.h"
#include "core/base/say.h"
#include "core/base/text.h"
#include "core/compensation/passport.h"

namespace heft {
namespace {

using nlohmann::json;

constexpr double kWithin = 1.96;         // Standard deviations of a 95 % interval
constexpr double kHopelessWidth = 20.0;  // Of the largest moment: an interval so wide says "not known" and no more

std::string textIn(const json& object, const char* key) {
  const auto found = object.find(key);
  return found != object.end() && found->is_string() ? found->get<std::string>() : std::string();
}

std::string heading(const std::string& text) { return fmt::format("<h2>{}</h2>\n", escapedMarkup(text)); }
std::string paragraph(const std::string& text) { return fmt::format("<p>{}</p>\n", escapedMarkup(text)); }
std::string strong(const std::string& text) { return fmt::format("<p><b>{}</b></p>\n", escapedMarkup(text)); }

std::string row(std::initializer_list<std::string> cells, bool head = false) {
  std::string out = "<tr>";
  for (const std::string& cell : cells)
    out += fmt::format(fmt::runtime(head ? "<th align=\"left\">{}</th>" : "<td>{}</td>"), escapedMarkup(cell));
  return out + "</tr>\n";
}
std::string table(const std::string& rows) {
  return "<table cellspacing=\"0\" cellpadding=\"3\">\n" + rows + "</table>\n";
}

std::string sourceWords(Source source) {
  switch (source) {
    case Source::data:
      return heft::say("measured");
    case Source::doubted:
      return heft::say("doubtful");
    case Source::prior:
      return heft::say("from your shape");
    case Source::none:
      break;
  }
  return heft::say("not known from this motion");
}

/// How a quantity is called, and its unit.
struct Shown {
  std::string name;
  PageUnits::Unit unit;
  int decimals;  ///< At most
};

/// Small tools read better in kg mm² than as 0.02 kg cm².
PageUnits::Unit inertiaUnit(double largest) {
  return largest < 0.5e-4 ? PageUnits::Unit{"kg mm²", 1e6, 0} : PageUnits::Unit{"kg cm²", 1e4, 0};
}

Shown shownAs(const std::string& quantity, const PageUnits& units, const PageUnits::Unit& inertia) {
  if (quantity == "mass_kg") return {heft::say("Mass"), units.mass, 4 + units.mass.decimals};
  if (quantity.starts_with("com_"))
    return {heft::say("Centre {}", quantity.substr(4, 1)), units.length, 1 + units.length.decimals};
  return {"I" + quantity.substr(8, 2), inertia, 2};
}

std::string numbersPart(const json& passport, const PageUnits& units) {
  const auto numbers = passportNumbers(passport);
  double largest = 0.0;
  for (const auto& n : numbers)
    if (n.quantity.starts_with("inertia_")) largest = std::max(largest, std::abs(n.value));
  const PageUnits::Unit inertia = inertiaUnit(largest);
  std::string rows = row({heft::say("Number"), heft::say("Value"), heft::say("95 %"), heft::say("Source")}, true);
  for (const auto& n : numbers) {
    const Shown shown = shownAs(n.quantity, units, inertia);
    const double half = 0.5 * (n.upper - n.lower) * shown.unit.scale;
    const int decimals = decimalsFor(half, shown.decimals);
    const bool hopeless = n.source == Source::none && n.quantity.starts_with("inertia_") &&
                          !(n.upper - n.lower < kHopelessWidth * largest);
    const double least = 0.5 * std::pow(10.0, -decimals);  // What writing it rounds away
    rows += row({shown.name, hopeless ? "—" : sayNumber(n.value * shown.unit.scale, decimals) + " " + shown.unit.name,
                 hopeless ? "" : "± " + sayNumber(std::max(half, least), decimals) + " " + shown.unit.name,
                 sourceWords(n.source)});
  }
  return heading(heft::say("Numbers, in the sensor’s axes")) + table(rows);
}

std::string joinedWith(const std::vector<std::string>& parts, const char* between) {
  return fmt::format("{}", fmt::join(parts, between));
}

std::string provedPart(const json& passport, const PageUnits& units) {
  std::string out = heading(heft::say("Proof"));
  const auto text = proofText(passport.value("proof", json()), nullptr, units);
  if (!text) return out + paragraph(heft::say("These numbers were not proved on another recording."));
  out += strong(text->headline);
  for (const auto& reason : text->reasons) out += paragraph(reason.text);
  return out + paragraph(joinedWith(text->facts, " "));
}

std::string causeSentenceOf(const json& cause) {
  return textIn(cause, "sentence") + " " +
         (cause.value("applied", false) ? heft::say("The numbers are corrected for it.")
                                        : heft::say("The numbers are not corrected for it."));
}

std::string causesPart(const json& passport) {
  std::string out = heading(heft::say("Causes of misfit"));
  if (!passport.value("looked_for_causes", false)) return out + paragraph(heft::say("The reality check was not run."));
  const json causes = passport.value("causes", json::array());
  if (causes.empty()) out += paragraph(heft::say("None were found."));
  for (const json& cause : causes) out += paragraph(causeSentenceOf(cause));
  std::vector<std::string> unseen;
  for (const json& phrase : passport.value("not_seen", json::array())) unseen.push_back(phrase.get<std::string>());
  if (!unseen.empty()) out += paragraph(heft::say("Not detectable in this recording: {}.", joined(unseen)));
  return out;
}

std::string verdictOfChange(const json& since) {
  return since.value("mass_and_centre_changed", false) || since.value("inertia_changed", false)
             ? heft::say("The tool has changed: the difference exceeds the measurement uncertainty.")
             : heft::say("No change beyond the measurement uncertainty.");
}

std::string changePart(const json& passport, const PageUnits& units) {
  const json since = passport.value("since", json());
  if (!since.is_object()) return {};
  std::string out = heading(heft::say("Since the passport of {}", textIn(since, "date")));
  out += paragraph(verdictOfChange(since));
  if (since.value("other_mount", false))
    out += paragraph(heft::say("The sensor mounting differs, so only the mass is compared."));
  std::string rows =
      row({heft::say("Number"), heft::say("Before"), heft::say("Now"), heft::say("Difference"), ""}, true);
  for (const json& each : since["numbers"]) {
    const Shown shown = shownAs(textIn(each, "quantity"), units, inertiaUnit(1.0));
    const double scale = shown.unit.scale, half = kWithin * scale * each["std"].get<double>();
    const int decimals = decimalsFor(half, shown.decimals);
    const auto number = [&](const char* key) { return sayNumber(scale * each[key].get<double>(), decimals); };
    rows += row({shown.name, number("before"), number("now"),
                 fmt::format("{} ± {} {}", number("difference"), sayNumber(half, decimals), shown.unit.name),
                 each["more_than_chance"].get<bool>() ? heft::say("changed") : std::string()});
  }
  return out + table(rows);
}

/// "2026-11-28, Heft Studio 0.2.0. Recording monday.csv."
std::string origin(const json& passport) {
  const std::filesystem::path file = textIn(passport.value("recording", json::object()), "file");
  return heft::say("{}, {}. Recording {}.", textIn(passport, "date"), textIn(passport, "program"),
                   printable(file.filename().string(), 200));
}

std::string lowTrust() { return heft::say("These numbers are not reliable; see the result’s warnings."); }

}  // namespace

std::string passportTitle(const json& passport) {
  return heft::say("Payload passport: {}", printable(textIn(passport, "tool"), 200));
}

std::string passportPage(const json& passport, const PageUnits& units, const std::string& language) {
  std::string out = fmt::format(
      "<!DOCTYPE html>\n<html lang=\"{0}\"><head><meta charset=\"utf-8\"><title>{1}</title>\n<style>"
      "body{{font-family:Inter,'Noto Sans',sans-serif;font-size:14px;color:#1C2630;background:#fff;max-width:720px;"
      "margin:24px auto}}"
      "h1{{font-size:24px}}h2{{font-size:18px;margin-top:24px}}"
      "td,th{{padding:3px 16px 3px 0;vertical-align:top}}th{{color:#4C5966}}</style></head><body>\n<h1>{1}</h1>\n",
      language, escapedMarkup(passportTitle(passport)));
  out += paragraph(origin(passport));
  if (textIn(passport, "trust") == "low") out += strong(lowTrust());
  out +=
      numbersPart(passport, units) + provedPart(passport, units) + causesPart(passport) + changePart(passport, units);
  return out + "</body></html>\n";
}

std::string passportText(const json& passport) {
  std::string out = passportTitle(passport) + "\n  " + origin(passport) + "\n";
  if (textIn(passport, "trust") == "low") out += "  " + lowTrust() + "\n";
  const auto mass = passportNumbers(passport).front();
  const double half = 0.5 * (mass.upper - mass.lower);
  const int decimals = decimalsFor(half, 4);
  out +=
      fmt::format("  {}: {} ± {} kg\n", heft::say("Mass"), sayNumber(mass.value, decimals), sayNumber(half, decimals));
  const auto proof = proofText(passport.value("proof", json()), nullptr);
  out += "  " + (proof ? proof->headline : heft::say("These numbers were not proved on another recording.")) + "\n";
  if (!passport.value("looked_for_causes", false)) out += "  " + heft::say("The reality check was not run.") + "\n";
  for (const json& cause : passport.value("causes", json::array())) out += "  " + causeSentenceOf(cause) + "\n";
  if (const json since = passport.value("since", json()); since.is_object())
    out +=
        fmt::format("  {}: {}\n", heft::say("Since the passport of {}", textIn(since, "date")), verdictOfChange(since));
  return out;
}

}  // namespace heft
