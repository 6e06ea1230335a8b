#include "Modules/CommandLine/SeedInput.h"

#include <charconv>
#include <cmath>

#include "Logic/Core/Errors.h"
#include "Logic/Core/LandmarkPairs.h"

namespace falciform::commandline {

namespace {

Vector3d parsePlace(const std::string& text, const std::string& refusal) {
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
  if (!good || at != end) throw InputError(refusal);
  return place;
}

}  // namespace

void declareSeeds(Syntax& syntax, const std::string& group, const std::string& what) {
  syntax.add({.name = "seed",
              .kind = ArgumentKind::Text,
              .label = "Seeds",
              .help = what + ": x,y,z;x,y,z;...",
              .group = group});
  syntax.add({.name = "seeds",
              .kind = ArgumentKind::Points,
              .label = "Seed points",
              .help = "The same from a file, .mrk.json or .fcsv; after those of --seed.",
              .group = group});
}

Landmarks seedPointsOf(const ParsedArguments& arguments, CommandRun& run) {
  Landmarks seeds;
  const std::string text = arguments.text("seed");
  for (std::size_t begin = 0; begin < text.size();) {
    const std::size_t end = std::min(text.find(';', begin), text.size());
    if (end > begin)
      seeds.points.push_back({"click " + std::to_string(seeds.points.size() + 1),
                              parsePlace(text.substr(begin, end - begin),
                                         "--seed is '" + text + "'; give places in mm as x,y,z;x,y,z")});
    begin = end + 1;
  }
  if (arguments.has("seeds"))
    for (const Landmark& point : run.landmarks(arguments.path("seeds")).points) seeds.points.push_back(point);
  return seeds;
}

Points seedsOf(const ParsedArguments& arguments, CommandRun& run) {
  return positionsOf(seedPointsOf(arguments, run));
}

Vector3d placeOf(const ParsedArguments& arguments, const std::string& name) {
  const std::string text = arguments.text(name);
  return parsePlace(text, "--" + name + " is '" + text + "'; give a place in mm as x,y,z");
}

}  // namespace falciform::commandline
