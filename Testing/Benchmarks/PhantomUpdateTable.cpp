// ./run bench update-phantom [--starts N] [--thesis-starts N] [--truth warp] [--svg FILE]: thesis Tables V.3
// and V.4, ours beside them, and Figure V.11: the virtual phantom with 43 beads under two packings, by full
// and partial surface, and from perturbed starts. The thesis's methods take a minute a start: with
// --thesis-starts 0 they are left out. The truth is CalculiX's, in no atlas's span.
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <fstream>

#include "Logic/Biomechanics/BlasKernel.h"
#include "Logic/Registration/PointRegistration.h"
#include "Testing/Benchmarks/CurveSvg.h"
#include "Testing/Benchmarks/PackedPhantom.h"
#include "Testing/Benchmarks/PerturbedStarts.h"
#include "Testing/Benchmarks/ThesisTable.h"

namespace falciform::bench {
namespace {

/// The phantom made ready for all methods.
class Workshop {
 public:
  explicit Workshop(PackedPhantoms made)
      : made_(std::move(made)),
        liver_(made_.preop),
        methods_(made_.preop, std::make_shared<const Atlas>(made_.atlas)) {}

  [[nodiscard]] const PackedPhantoms& made() const { return made_; }

  [[nodiscard]] Isometry3d thesisStart(UpdateMethod method, const UpdateTrial& trial) const {
    return method == UpdateMethod::Icat ? methods_.icp(liver_, trial) : methods_.picp(liver_, trial);
  }
  [[nodiscard]] MethodOutcome thesis(UpdateMethod method, const UpdateTrial& trial,
                                     const Isometry3d& start) const {
    return methods_.update(method, trial, start);
  }
  [[nodiscard]] Isometry3d registered(const UpdateTrial& trial) const {
    return registerSurfaces(liver_.rigid(), trial.scan, {}).scanFromPreop;
  }
  /// Ours by surface loads, no atlas.
  [[nodiscard]] MethodOutcome ours(const UpdateTrial& trial, const Isometry3d& start) const {
    MethodOutcome done;
    TrialResult r = runTrialFrom(liver_, trial, start);
    done.rigid = r.registered;
    done.updated = r.updated;
    done.updatedMm = std::move(r.updatedMm);
    done.places = scanFromPreop(liver_.model(), r.update, trial.before);
    done.update = std::move(r.update);
    expectedMm_ = r.expectedMm;
    return done;
  }
  /// As the application does it: the start goes to the registration.
  [[nodiscard]] MethodOutcome oursRegistered(const UpdateTrial& trial, const Isometry3d& start) const {
    RegistrationSettings given;
    given.start = RegistrationStart::Given;
    return ours(trial, registerSurfaces(liver_.rigid(), trial.scan, given, start).scanFromPreop);
  }
  [[nodiscard]] double lastExpectedMm() const { return expectedMm_; }

 private:
  PackedPhantoms made_;
  ReadyLiver liver_;
  ThesisMethods methods_;
  mutable double expectedMm_ = 0;
};

void printThesisTables(const Workshop& shop) {
  for (const UpdateMethod method : {UpdateMethod::Icat, UpdateMethod::IcatStar}) {
    const bool star = method == UpdateMethod::IcatStar;
    std::vector<MeasuredRow> rows;
    for (const PackedPhantom& p : shop.made().packings) {
      const MethodOutcome full = shop.thesis(method, p.full, shop.thesisStart(method, p.full)),
                          partial = shop.thesis(method, p.partial, shop.thesisStart(method, p.partial));
      rows.push_back({p.packing, p.before, full.rigid, full.updated, partial.rigid, partial.updated});
    }
    std::printf("Table V.%d\n\n", star ? 4 : 3);
    printThesisTable(star ? "PICP" : "ICP", star ? "ICAt\\*" : "ICAt", rows,
                     star ? kThesisTableV4 : kThesisTableV3);
  }
}

void printOurs(const Workshop& shop) {
  std::puts(
      "| packing | push reached | seen | truth's min det J | surface | optimal rigid | registered | ours, "
      "atlas "
      "| ours, no atlas | expected | min det J | steps |\n|---|---|---|---|---|---|---|---|---|---|---|---|");
  for (const PackedPhantom& p : shop.made().packings)
    for (const auto& [name, trial] : {std::pair("full", &p.full), {"partial", &p.partial}}) {
      const Isometry3d start = shop.registered(*trial);
      const MethodOutcome ours = shop.ours(*trial, start),
                          withAtlas = shop.thesis(UpdateMethod::Loads, *trial, start);
      const ErrorFigures optimal =
          figuresOf(targetErrors(trial->before, trial->after, fitRigid(trial->before, trial->after)));
      std::printf("| %s | %.0f %% | %.0f %% | %.2f | %s | %s | %s | %s | %s | %.2f | %.2f | %d%s |\n",
                  p.packing.c_str(), 100 * p.share, 100 * p.coverage, p.minDetJ, name,
                  asInThesis(optimal).c_str(), asInThesis(ours.rigid).c_str(),
                  asInThesis(withAtlas.updated).c_str(), asInThesis(ours.updated).c_str(),
                  shop.lastExpectedMm(), ours.update.minDetJ, ours.update.iterations,
                  ours.update.converged ? "" : "!");
      std::fflush(stdout);
    }
  std::puts("");
}

/// The thesis's trial has ICAt and ICAt* on the partial surface, ICAt* on the full one; ours beside them.
std::vector<PerturbedOutcome> perturbations(const Workshop& shop, const UpdateTrial& trial, bool full,
                                            PerturbedPlan plan, int thesisStarts) {
  std::vector<PerturbedOutcome> all;
  const Isometry3d pose = shop.registered(trial);
  if (!full)
    all.push_back(perturbed(
        "ours, start to the fit", trial.scan, pose,
        [&](const Isometry3d& start) { return shop.ours(trial, start); }, plan));
  all.push_back(perturbed(
      "ours", trial.scan, pose, [&](const Isometry3d& start) { return shop.oursRegistered(trial, start); },
      plan));
  if (thesisStarts == 0) return all;
  plan.starts = thesisStarts;
  for (const UpdateMethod method : {UpdateMethod::IcatStar, UpdateMethod::Icat})
    if (!full || method == UpdateMethod::IcatStar)
      all.push_back(perturbed(
          method == UpdateMethod::Icat ? "ICAt" : "ICAt*", trial.scan, shop.thesisStart(method, trial),
          [&](const Isometry3d& start) { return shop.thesis(method, trial, start); }, plan));
  return all;
}

/// Share of errors up to each of 0 to 10 mm.
std::vector<double> cumulative(const VectorXd& errorsMm, const std::vector<double>& upTo) {
  std::vector<double> shares;
  for (const double x : upTo)
    shares.push_back(static_cast<double>((errorsMm.array() <= x).count()) /
                     static_cast<double>(errorsMm.size()));
  return shares;
}

/// Partial surface solid; full surface dashed, where the method was tried on it.
CurvePanel panelOf(const std::string& packing, const std::vector<PerturbedOutcome>& full,
                   const std::vector<PerturbedOutcome>& partial) {
  CurvePanel panel{packing + " lobe packed", "bead errors up to, mm", {}};
  const std::vector<double> upTo{0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10};
  for (const PerturbedOutcome& p : partial) {
    if (p.method.find(',') != std::string::npos) continue;
    Curve curve{p.method, upTo, cumulative(p.errorsMm, upTo), {}};
    for (const PerturbedOutcome& f : full)
      if (f.method == p.method) curve.dashed = cumulative(f.errorsMm, upTo);
    panel.curves.push_back(std::move(curve));
  }
  return panel;
}

std::vector<CurvePanel> printPerturbations(const Workshop& shop, const PerturbedPlan& plan,
                                           int thesisStarts) {
  std::printf(
      "Figure V.11: starts perturbed by up to %.0f deg and %.0f mm along each axis. Thesis, 25 starts: "
      "partial "
      "ICAt %.1f±%.1f, partial ICAt\\* %.1f±%.1f, full ICAt\\* %.1f±%.1f.\n\n",
      plan.turnDeg, plan.shiftMm, kThesisPerturbedIcatPartial.mean, kThesisPerturbedIcatPartial.sd,
      kThesisPerturbedIcatStarPartial.mean, kThesisPerturbedIcatStarPartial.sd,
      kThesisPerturbedIcatStarFull.mean, kThesisPerturbedIcatStarFull.sd);
  std::puts(
      "| packing | surface | method | starts | mean error over starts | largest mean | one bead, two starts: "
      "apart at most |\n|---|---|---|---|---|---|---|");
  std::vector<CurvePanel> panels;
  for (const PackedPhantom& p : shop.made().packings) {
    std::vector<std::vector<PerturbedOutcome>> both;
    for (const auto& [name, trial] : {std::pair("full", &p.full), {"partial", &p.partial}}) {
      both.push_back(perturbations(shop, *trial, trial == &p.full, plan, thesisStarts));
      for (const PerturbedOutcome& o : both.back())
        std::printf("| %s | %s | %s | %d | %.2f±%.2f | %.2f | %.2f |\n", p.packing.c_str(), name,
                    o.method == "ICAt*" ? "ICAt\\*" : o.method.c_str(), o.starts, o.meanMm.mean, o.meanMm.sd,
                    o.meanMm.largest, o.farthestMm);
      std::fflush(stdout);
    }
    panels.push_back(panelOf(p.packing, both[0], both[1]));
  }
  return panels;
}

int run(int count, char** words) {
  PerturbedPlan plan;
  PackedPhantomPlan phantom;
  int thesisStarts = plan.starts;
  const char* svg = nullptr;
  for (int i = 1; i + 1 < count; i += 2) {
    if (std::strcmp(words[i], "--starts") == 0) plan.starts = std::max(2, std::atoi(words[i + 1]));
    if (std::strcmp(words[i], "--thesis-starts") == 0) thesisStarts = std::max(0, std::atoi(words[i + 1]));
    if (std::strcmp(words[i], "--truth") == 0) phantom.calculix = std::strcmp(words[i + 1], "warp") != 0;
    if (std::strcmp(words[i], "--svg") == 0) svg = words[i + 1];
  }
  const Workshop shop(packedPhantoms(phantom));
  std::printf(
      "Truth by %s. %zu beads; atlas of %zu members, rank %td. Errors at the beads, mm: "
      "mean±sd(largest).\n\n",
      phantom.calculix ? "CalculiX, neo-Hookean" : "linear elasticity with true turns",
      shop.made().beads.points.size(), shop.made().atlas.members.size(), shop.made().atlas.rank());
  printOurs(shop);
  if (thesisStarts > 0) printThesisTables(shop);
  const std::vector<CurvePanel> panels = printPerturbations(shop, plan, thesisStarts);
  if (svg != nullptr) std::ofstream(svg) << curvesSvg(panels, "partial surface", "full surface");
  return 0;
}

}  // namespace
}  // namespace falciform::bench

int main(int count, char** words) {
  falciform::restartWithBestBlasKernel(words);
  try {
    return falciform::bench::run(count, words);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return 2;
  }
}
