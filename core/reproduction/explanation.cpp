// Sentences about the numbers of one run. Each is built from them, so that another seed or sensor cannot make it false.
#include <fmt/format.h>

#include <algorithm>

#include "core/reproduction/reproduction.h"

namespace heft {

namespace {

std::string percent(double error) { return fmt::format("{:.3g} %", 100.0 * error); }

std::string_view noun(Quantity quantity) {
  return quantity == Quantity::mass ? "mass" : quantity == Quantity::com ? "centre of mass" : "inertia";
}

const ErrorRow* find(const ErrorTable& table, ParameterSet estimated, Quantity quantity, DataKind data) {
  for (const auto& row : table.rows)
    if (row.estimated == estimated && row.quantity == quantity && row.data == data) return &row;
  return nullptr;
}

/// "bias 4 %, tilt 1 %, delay 0.2 %", the strongest first.
std::string ranked(std::vector<std::pair<std::string, double>> causes) {
  std::ranges::stable_sort(causes, std::greater{}, &std::pair<std::string, double>::second);
  std::string text;
  for (const auto& [cause, error] : causes)
    text += fmt::format("{}{} {}", text.empty() ? "" : ", ", cause, percent(error));
  return text;
}

/// On data without noise.
void explainValidation(const ErrorTable& predefined, std::vector<std::string>& sentences) {
  const auto validation = [&](Quantity quantity) {
    return find(predefined, ParameterSet::full, quantity, DataKind::validation);
  };
  const ErrorRow* const mass = validation(Quantity::mass);
  const ErrorRow* const com = validation(Quantity::com);
  const ErrorRow* const inertia = validation(Quantity::inertia);
  if (mass && com && inertia && inertia->paperCeres && inertia->paperEigenLm) {
    const double ours = std::max(inertia->ceres, inertia->eigenLm);
    const double paper = std::min(*inertia->paperCeres, *inertia->paperEigenLm);
    sentences.push_back(fmt::format(
        "Validation data, all ten: the paper's equation holds exactly but for smoothing, and with solvers that run "
        "until "
        "they converge it leaves {} of mass, {} of the centre and {} of inertia.",
        percent(std::max(mass->ceres, mass->eigenLm)), percent(std::max(com->ceres, com->eigenLm)), percent(ours)));
    if (ours < 0.5 * paper)
      sentences.push_back(fmt::format(
          "The paper's inertia errors on such data ({} and {}) are larger than that by a factor of {:.2g} at least: "
          "what "
          "it saw there is not explained by this motion and smoothing, so look at the solvers' scaling and stopping.",
          percent(*inertia->paperCeres), percent(*inertia->paperEigenLm), paper / ours));
  }
}

/// What the sensor's bias does to mass and inertia.
void explainBias(const Reproduction& all, std::vector<std::string>& sentences) {
  const CauseRow& noise = all.causes.front();
  // Without noise the error that a bias makes is proportional to it, so the paper's error tells the paper's bias.
  const ErrorRow* const full = find(all.errors.front(), ParameterSet::full, Quantity::mass, DataKind::measured);
  const auto bias = std::ranges::find(all.causes, "bias", &CauseRow::cause);
  if (full && full->paperCeres && full->paperEigenLm && bias != all.causes.end() &&
      bias->paper.mass > 10.0 * noise.paper.mass) {
    const double newtons = all.forceBias / bias->paper.mass;
    sentences.push_back(fmt::format(
        "A force bias of {:.2g} N made the mass error of {}, in proportion; the paper's {} and {} would take "
        "{:.2g} N and {:.2g} N of bias{}.",
        all.forceBias, percent(bias->paper.mass), percent(*full->paperCeres), percent(*full->paperEigenLm),
        newtons * *full->paperCeres, newtons * *full->paperEigenLm,
        newtons * *full->paperEigenLm < 1.0 ? ", as tared sensors have that drifted a little" : ""));
  }
  if (all.inertialTorque > 0.0 && all.torqueBias > 0.0)
    sentences.push_back(fmt::format(
        "The inertia makes a torque of {:.2g} N m (root mean square) in this motion, the sensor's bias one of {:.2g} N "
        "m, "
        "{}: an equation without bias has to explain that torque by the payload.",
        all.inertialTorque, all.torqueBias,
        all.torqueBias > all.inertialTorque ? fmt::format("{:.2g} times as much", all.torqueBias / all.inertialTorque)
                                            : fmt::format("{} of it", percent(all.torqueBias / all.inertialTorque))));
}

void explainRuntimes(const Reproduction& all, std::vector<std::string>& sentences) {
  const RuntimeRow* longest = nullptr;
  std::size_t set = 0;
  for (const auto& row : all.runtimes)
    for (std::size_t p = 0; p < kParameterSets.size(); ++p)
      if (row.paper[p] && (!longest || row.paper[p]->seconds > longest->paper[set]->seconds)) {
        longest = &row;
        set = p;
      }
  if (longest && longest->solve[set] > 0.0)
    sentences.push_back(fmt::format(
        "Runtimes: an orthogonal transformation turns the {} rows into 17 without loss, so {} takes {:.2g} ms where "
        "the "
        "paper took {:.3g} h for a tenth of the samples.",
        all.rows, toString(longest->method), 1e3 * longest->solve[set], longest->paper[set]->seconds / 3600.0));
}

}  // namespace

std::vector<std::string> explain(const Reproduction& all) {
  std::vector<std::string> sentences;
  const ErrorTable& predefined = all.errors.front();
  const CauseRow& noise = all.causes.front();
  const CauseRow& together = all.causes.back();
  const std::vector<CauseRow> single(all.causes.begin() + 1, all.causes.end() - 1);

  explainValidation(predefined, sentences);
  for (const Quantity quantity : {Quantity::mass, Quantity::com, Quantity::inertia}) {
    std::vector<std::pair<std::string, double>> causes;
    for (const auto& cause : single) causes.emplace_back(cause.cause, cause.paper.of(quantity));
    sentences.push_back(fmt::format(
        "Measured data as the paper did, error of the {}: noise alone makes {}; with one cause on top: {}; all "
        "together "
        "{}.",
        noun(quantity), percent(noise.paper.of(quantity)), ranked(causes), percent(together.paper.of(quantity))));
  }
  explainBias(all, sentences);
  for (const auto& cause : single)
    sentences.push_back(fmt::format(
        "Heft's default under {} alone: mass {}, centre {}, inertia {} (as the paper did: {}, {}, {}; Heft with noise "
        "alone: {}, {}, {}).",
        cause.cause, percent(cause.heft.mass), percent(cause.heft.com), percent(cause.heft.inertia),
        percent(cause.paper.mass), percent(cause.paper.com), percent(cause.paper.inertia), percent(noise.heft.mass),
        percent(noise.heft.com), percent(noise.heft.inertia)));
  std::vector<std::pair<std::string, double>> left;
  for (const auto& cause : single) left.emplace_back(cause.cause, cause.heft.inertia);
  sentences.push_back(fmt::format("What is left in Heft's inertia with everything together is {}; alone: {}.",
                                  percent(together.heft.inertia), ranked(left)));

  explainRuntimes(all, sentences);
  return sentences;
}

}  // namespace heft
