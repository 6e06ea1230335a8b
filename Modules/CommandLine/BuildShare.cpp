#include "Modules/CommandLine/BuildShare.h"

#include <unistd.h>

#include <algorithm>
#include <cstdlib>

#include "Logic/Core/Errors.h"
#include "Logic/Core/Parallel.h"
#include "Modules/CommandLine/ParsedArguments.h"

namespace falciform::commandline {

namespace {

int fromEnvironment(const char* name, int fallback) {
  const char* text = std::getenv(name);
  return text == nullptr ? fallback : parseInteger(name, text);
}

BuildShare checked(const BuildShare& share, const std::string& what) {
  if (share.count < 1 || share.index < 0 || share.index >= share.count)
    throw InputError(what + " is " + std::to_string(share.index) + "/" + std::to_string(share.count) +
                     "; give number/count with the number from 0 to count - 1");
  return share;
}

}  // namespace

std::vector<int> BuildShare::of(int items) const {
  const auto border = [&](int k) { return static_cast<int>(static_cast<long long>(items) * k / count); };
  std::vector<int> mine;
  for (int k = border(index); k < border(index + 1); ++k) mine.push_back(k);
  return mine;
}

BuildShare buildShare(const std::string& text) {
  if (text.empty())
    return checked({fromEnvironment("OMPI_COMM_WORLD_RANK", 0), fromEnvironment("OMPI_COMM_WORLD_SIZE", 1)},
                   "OMPI_COMM_WORLD_RANK/SIZE");
  const std::size_t slash = text.find('/');
  if (slash == std::string::npos)
    throw InputError("--shard is '" + text + "'; give number/count, as 0/10 for the first of ten");
  return checked(
      {parseInteger("--shard", text.substr(0, slash)), parseInteger("--shard", text.substr(slash + 1))},
      "--shard");
}

void shareThreads() {
  const int processes = fromEnvironment("OMPI_COMM_WORLD_LOCAL_SIZE", 1);
  const auto cores = static_cast<int>(sysconf(_SC_NPROCESSORS_ONLN));
  if (processes > 1 && threads() >= cores) setThreads(std::max(1, cores / processes));
}

}  // namespace falciform::commandline
