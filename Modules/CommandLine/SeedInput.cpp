#include "Modules/CommandLine/SeedInput.h"

#include <charconv>
#include <cmath>

#include "Logic/Core/Errors.h"

namespace falciform::commandline {

namespace {

Vector3d placeOf(const std::string& text, const std::string& all) {
  Vector3d place;
  const char* at = text.data();
  const char* const end = at + text.size();
  const auto skip = [&] {
    while (at < end && *at == ' ') ++at;
  };
  bool good = true;
  for (int axis = 0; axis < 3 && good; ++axis) {
    skip();
    if (axis > 0) good = at < end && *at++ == ',';
    skip();
    const auto [next, error] = std::from_chars(at, end, place[axis]);
    good = good && error == std::errc() && std::isfinite(place[axis]);
    at = next;
  }
  skip();
  if (!good || at != end)
    throw InputError("--seed is '" + all + "'; give places in patient LPS mm as x,y,z;x,y,z");
  return place;
}

}  // namespace

Points seedsOf(const ParsedArguments& arguments, CommandRun& run) {
  std::vector<Vector3d> places;
  const std::string text = arguments.text("seed");
  for (std::size_t begin = 0; begin < text.size();) {
    const std::size_t end = std::min(text.find(';', begin), text.size());
    if (end > begin) places.push_back(placeOf(text.substr(begin, end - begin), text));
    begin = end + 1;
  }
  if (arguments.has("seeds"))
    for (const Landmark& point : run.landmarks(arguments.path("seeds")).points)
      places.push_back(point.position);
  Points seeds(static_cast<Index>(places.size()), 3);
  for (std::size_t s = 0; s < places.size(); ++s) seeds.row(static_cast<Index>(s)) = places[s].transpose();
  return seeds;
}

}  // namespace falciform::commandline
