#include "Logic/Acquisition/ScanPreparationLogic.h"

#include <algorithm>

#include "Logic/Acquisition/ScanGraph.h"
#include "Logic/Core/Errors.h"
#include "Logic/Geometry/Measures.h"
#include "Logic/Geometry/Topology.h"

namespace falciform {

namespace {

/// Same points in the same places, whatever is painted on them.
bool sameShape(const std::shared_ptr<const Surface>& a, const std::shared_ptr<const Surface>& b) {
  return a == b || (a && b && a->points.rows() == b->points.rows() && a->points == b->points);
}

}  // namespace

ScanPreparationLogic::ScanPreparationLogic(Case& document) : case_(document) {
  follow();
  watching_ = case_.changed.connect([this](Case::Part part) {
    if (part == Case::Part::Scan) follow();
  });
}

/// Another scan in the case begins anew; ours, painted on or finished, does not.
void ScanPreparationLogic::follow() {
  const auto& scan = case_.scan();
  if (scan && (sameShape(scan, shown_) || sameShape(scan, finished_) || sameShape(scan, raw_))) return;
  raw_ = scan;
  shown_.reset();
  finished_.reset();
  marked_.reset();
  byHand_.assign(scan ? static_cast<std::size_t>(scan->size()) : 0, ByHand::No);
  shownLabels_.clear();
}

std::string ScanPreparationLogic::missingInput() const {
  if (!raw_) return "Open a scan first.";
  if (raw_->size() < 3) return "The scan has fewer than 3 points.";
  return {};
}

std::string ScanPreparationLogic::missingMarks() const {
  if (const std::string missing = missingInput(); !missing.empty()) return missing;
  return marked_ ? "" : "Mark what goes first.";
}

/// Whatever differs from what we put there was painted since. Patches painted before the first marks belong
/// to the raw scan.
void ScanPreparationLogic::gatherHandwork() {
  const auto& scan = case_.scan();
  if (!scan || !sameShape(scan, shown_ ? shown_ : raw_)) return;
  for (std::size_t i = 0; i < byHand_.size(); ++i) {
    const int now = scan->patchAt(static_cast<Index>(i));
    const int before = shownLabels_.empty() ? raw_->patchAt(static_cast<Index>(i)) : shownLabels_[i];
    if (now == before || (!shown_ && now < scan_label::kFirst)) continue;
    byHand_[i] = now == scan_label::kSeed      ? ByHand::Seed
                 : scan_label::goes(now)       ? ByHand::Goes
                 : before == scan_label::kSeed ? ByHand::No
                                               : ByHand::Stays;
  }
  shownLabels_ = scan->patch;
  shownLabels_.resize(byHand_.size(), patch::kNone);
  if (shown_ || scan == raw_) return;
  auto raw = std::make_shared<Surface>(*scan);
  for (int& label : raw->patch)
    if (label >= scan_label::kFirst) label = patch::kNone;
  raw_ = raw;
}

/// One for each dab: its point nearest to the middle; mm, in the marked scan's size.
Points ScanPreparationLogic::seeds() const {
  std::vector<char> painted(byHand_.size());
  for (std::size_t i = 0; i < painted.size(); ++i) painted[i] = byHand_[i] == ByHand::Seed;
  if (std::find(painted.begin(), painted.end(), 1) == painted.end()) return Points(0, 3);
  const ScanPieces dabs = scanPieces(*raw_, scanNeighbours(*raw_), painted);
  Points places(static_cast<Index>(dabs.areaMm2.size()), 3);
  for (Index dab = 0; dab < places.rows(); ++dab) {
    std::vector<int> ids;
    for (std::size_t i = 0; i < dabs.of.size(); ++i)
      if (dabs.of[i] == dab) ids.push_back(static_cast<int>(i));
    const Points of = raw_->points(ids, Eigen::all);
    Index middle = 0;
    (of.rowwise() - centroid(of).transpose()).rowwise().squaredNorm().minCoeff(&middle);
    places.row(dab) = of.row(middle);
  }
  return places;
}

std::function<MarkedScan(const Progress&)> ScanPreparationLogic::prepareMarks() {
  if (const std::string missing = missingInput(); !missing.empty()) throw InputError(missing);
  gatherHandwork();
  const UnitGuess guess = guessUnit(raw_->points);
  const bool automatic = settings.unit == LengthUnit::Automatic;
  const double factor = millimetresIn(automatic && guess.certain ? guess.unit : settings.unit);
  return [raw = raw_, places = Points(seeds() * factor), now = settings](const Progress& progress) {
    return markScan(*raw, places, std::nullopt, now, progress);
  };
}

void ScanPreparationLogic::acceptMarks(MarkedScan marked) {
  if (!raw_ || marked.scan.size() != raw_->size()) return;
  gatherHandwork();
  auto painted = std::make_shared<Surface>(marked.scan);
  painted->patch.resize(byHand_.size(), patch::kNone);
  for (std::size_t i = 0; i < byHand_.size(); ++i) {
    if (byHand_[i] == ByHand::Goes) marked.marks[i] = ScanMark::ByHand;
    if (byHand_[i] == ByHand::Stays || byHand_[i] == ByHand::Seed) marked.marks[i] = ScanMark::Kept;
    if (marked.marks[i] != ScanMark::Kept)
      painted->patch[i] = scan_label::kFirst + static_cast<int>(marked.marks[i]);
    if (byHand_[i] == ByHand::Seed) painted->patch[i] = scan_label::kSeed;
    const int own = shownLabels_.empty() ? patch::kNone : shownLabels_[i];
    if (own != patch::kNone && own < scan_label::kFirst && marked.marks[i] == ScanMark::Kept)
      painted->patch[i] = own;
  }
  for (int mark = 1; mark <= static_cast<int>(ScanMark::ByHand); ++mark)
    painted->patchNames[scan_label::kFirst + mark] = "goes: " + enumToString(static_cast<ScanMark>(mark));
  painted->patchNames[scan_label::kSeed] = "liver, by hand";
  marked_ = std::make_unique<MarkedScan>(std::move(marked));
  shownLabels_ = painted->patch;
  shown_ = painted;
  finished_.reset();
  case_.setScan(painted);
}

void ScanPreparationLogic::hideMarks() {
  if (!marked_ || !sameShape(case_.scan(), shown_)) return;
  gatherHandwork();
  auto bare = std::make_shared<Surface>(*case_.scan());
  for (int& label : bare->patch)
    if (label >= scan_label::kFirst) label = patch::kNone;
  std::erase_if(bare->patchNames, [](const auto& name) { return name.first >= scan_label::kFirst; });
  shownLabels_ = bare->patch;
  case_.setScan(bare);
}

void ScanPreparationLogic::showMarks() {
  if (marked_ && sameShape(case_.scan(), shown_)) acceptMarks(MarkedScan(*marked_));
}

ScanMark ScanPreparationLogic::markAt(Index point) const {
  const int label = case_.scan()->patchAt(point);
  return scan_label::goes(label) ? static_cast<ScanMark>(label - scan_label::kFirst) : ScanMark::Kept;
}

std::function<Surface(const Progress&)> ScanPreparationLogic::prepareFinish() {
  if (const std::string missing = missingMarks(); !missing.empty()) throw InputError(missing);
  if (!sameShape(case_.scan(), shown_)) throw InputError("The scan is prepared already.");
  MarkedScan mended = *marked_;
  for (Index i = 0; i < mended.scan.size(); ++i) {
    mended.marks[static_cast<std::size_t>(i)] = markAt(i);
    // A patch of before, wherever a mark stood on it for a while.
    const int label = case_.scan()->patchAt(i);
    if (!mended.scan.patch.empty() && label != patch::kNone && label < scan_label::kFirst)
      mended.scan.patch[static_cast<std::size_t>(i)] = label;
  }
  return [mended = std::move(mended), now = settings](const Progress& progress) {
    return finishScan(mended, now, progress);
  };
}

void ScanPreparationLogic::acceptFinish(Surface prepared) {
  finished_ = std::make_shared<const Surface>(std::move(prepared));
  case_.setScan(finished_);
}

void ScanPreparationLogic::restoreRaw() {
  if (!raw_) return;
  const auto raw = raw_;
  raw_.reset();  // so that it is taken as one just opened
  shown_.reset();
  finished_.reset();
  case_.setScan(raw);
}

bool ScanPreparationLogic::canRestore() const { return raw_ && case_.scan() != raw_; }

const MarkedScan* ScanPreparationLogic::marked() const { return marked_.get(); }

Index ScanPreparationLogic::count(ScanMark mark) const {
  if (!marked_ || !sameShape(case_.scan(), shown_)) return 0;
  Index count = 0;
  for (Index i = 0; i < case_.scan()->size(); ++i) count += markAt(i) == mark;
  return count;
}

UnitGuess ScanPreparationLogic::unitGuess() const { return raw_ ? guessUnit(raw_->points) : UnitGuess{}; }

}  // namespace falciform
