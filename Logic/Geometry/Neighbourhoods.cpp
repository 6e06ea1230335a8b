#include "Logic/Geometry/Neighbourhoods.h"

#include <algorithm>

#include "Logic/Core/Errors.h"

namespace falciform {

Neighbourhoods::Neighbourhoods(const Surface& surface, const CurvatureSettings& settings)
    : surface_(surface), settings_(settings) {
  checkSettings(settings);
  if (surface.triangles.rows() > 0) {
    rings_ = std::make_unique<VertexRings>(surface);
  } else if (surface.normals.rows() == surface.size()) {
    tree_ = KdTree(surface.points);
  } else {
    throw InputError(
        "a cloud of points without normals has no outside, so its curvature has no sign; give it normals");
  }
}

std::unique_ptr<Neighbourhoods::Scratch> Neighbourhoods::borrow() const {
  {
    const std::lock_guard lock(guard_);
    if (!free_.empty()) {
      std::unique_ptr<Scratch> scratch = std::move(free_.back());
      free_.pop_back();
      return scratch;
    }
  }
  auto scratch = std::make_unique<Scratch>();
  if (rings_) scratch->seenIn.assign(static_cast<std::size_t>(surface_.size()), 0);
  return scratch;
}

void Neighbourhoods::giveBack(std::unique_ptr<Scratch> scratch) const {
  const std::lock_guard lock(guard_);
  free_.push_back(std::move(scratch));
}

Vector3d Neighbourhoods::normal(int place) const {
  if (rings_) return rings_->normal(rings_->representative(place));
  return surface_.normals.row(place);
}

void Neighbourhoods::gather(int place, Scratch& scratch) const {
  scratch.found.clear();
  if (!rings_) {
    gatherCloud(place, scratch);
  } else {
    const int centre = rings_->representative(place);
    if (settings_.radiusMm > 0) gatherConnected(centre, scratch);
    if (static_cast<int>(scratch.found.size()) < settings_.neighbours) gatherRings(centre, scratch);
  }
  if (!settings_.linearTerms) keepNearest(place, scratch);
}

/// Whole rings until there are enough: so that the answer does not depend on the order of the vertices.
void Neighbourhoods::gatherRings(int place, Scratch& scratch) const {
  const unsigned question = ++scratch.question;
  unsigned* const seen = scratch.seenIn.data();
  std::vector<int>& found = scratch.found;
  found.assign(rings_->begin(place), rings_->end(place));
  seen[place] = question;
  for (const int v : found) seen[v] = question;
  const auto wanted = static_cast<std::size_t>(settings_.neighbours);
  for (std::size_t from = 0; found.size() < wanted && from < found.size();) {
    const std::size_t to = found.size();
    for (; from < to; ++from)
      for (const int *v = rings_->begin(found[from]), *end = rings_->end(found[from]); v != end; ++v) {
        if (seen[*v] == question) continue;
        seen[*v] = question;
        found.push_back(*v);
      }
  }
}

/// What is within the radius and joined to the place inside it: not the other side of a thin lobe.
void Neighbourhoods::gatherConnected(int place, Scratch& scratch) const {
  const unsigned question = ++scratch.question;
  unsigned* const seen = scratch.seenIn.data();
  std::vector<int>& found = scratch.found;
  const double bound = settings_.radiusMm * settings_.radiusMm;
  const Vector3d here = surface_.points.row(place);
  const auto spread = [&](int from) {
    for (const int *v = rings_->begin(from), *end = rings_->end(from); v != end; ++v) {
      if (seen[*v] == question) continue;
      seen[*v] = question;
      if (squaredDistance(here, surface_.points.row(*v)) <= bound) found.push_back(*v);
    }
  };
  seen[place] = question;
  spread(place);
  for (std::size_t i = 0; i < found.size(); ++i) spread(found[i]);
}

void Neighbourhoods::gatherCloud(int place, Scratch& scratch) const {
  const Vector3d here = surface_.points.row(place), facing = surface_.normals.row(place);
  const auto take = [&](int v) {
    if (v != place && surface_.normals.row(v).dot(facing) > 0) scratch.found.push_back(v);
  };
  if (settings_.radiusMm > 0)
    for (const int v : tree_.within(here, settings_.radiusMm)) take(v);
  if (static_cast<int>(scratch.found.size()) >= settings_.neighbours) return;
  // Of the nearest some may face away, through a thin lobe: more are asked for until enough do not.
  for (int asked = settings_.neighbours + 1;; asked *= 2) {
    scratch.found.clear();
    for (const Neighbour& neighbour : tree_.nearest(here, asked))
      if (static_cast<int>(scratch.found.size()) < settings_.neighbours) take(neighbour.index);
    const bool enough = static_cast<int>(scratch.found.size()) == settings_.neighbours;
    if (enough || asked >= std::min(tree_.size(), 8 * settings_.neighbours)) return;
  }
}

void Neighbourhoods::keepNearest(int place, Scratch& scratch) const {
  const auto wanted = static_cast<std::size_t>(settings_.neighbours);
  if (scratch.found.size() <= wanted) return;
  const Vector3d here = surface_.points.row(place);
  scratch.byDistance.clear();
  for (const int v : scratch.found)
    scratch.byDistance.emplace_back(squaredDistance(here, surface_.points.row(v)), v);
  std::nth_element(scratch.byDistance.begin(),
                   scratch.byDistance.begin() + static_cast<std::ptrdiff_t>(wanted),
                   scratch.byDistance.end());
  scratch.found.clear();
  for (std::size_t i = 0; i < wanted; ++i) scratch.found.push_back(scratch.byDistance[i].second);
}

}  // namespace falciform
