#include "Testing/Fuzz/FuzzRun.h"

#include <sys/mman.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <atomic>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <iterator>
#include <new>
#include <thread>

#include "Logic/Core/Errors.h"
#include "Testing/Fuzz/Mutation.h"
#include "Testing/Support/MemoryFile.h"
#include "Testing/Support/TemporaryFolder.h"

#if defined(__SANITIZE_ADDRESS__)
constexpr bool kSanitized = true;  // AddressSanitizer reserves terabytes, and has its own operator new
#else
constexpr bool kSanitized = false;
#endif

namespace {

std::atomic<std::size_t> largestRequest{0};

}  // namespace

#if !defined(__SANITIZE_ADDRESS__)
// Every request of C++ code is seen, whether or not the pages are ever touched.
void* operator new(std::size_t bytes) {
  std::size_t largest = largestRequest;
  while (bytes > largest && !largestRequest.compare_exchange_weak(largest, bytes)) {
  }
  if (void* memory = std::malloc(bytes ? bytes : 1)) return memory;
  throw std::bad_alloc();
}
void operator delete(void* memory) noexcept { std::free(memory); }
void operator delete(void* memory, std::size_t) noexcept { std::free(memory); }
#endif

namespace falciform::test {

namespace {

constexpr double kSecondsAMutant = 10;
constexpr std::size_t kSpareBytes = std::size_t{256} << 20;
constexpr std::size_t kDeflateAtBest = 1032;

/// What the child tells while it runs.
struct Shared {
  std::atomic<int> mutant;
  int read, refused;
  double slowestMs, largestMb;
  bool finished;
  char failure[400];
};

std::size_t addressSpace() {
  std::size_t pages = 0;
  std::ifstream("/proc/self/statm") >> pages;
  return pages * static_cast<std::size_t>(sysconf(_SC_PAGESIZE));
}

void limitMemory(std::size_t fileBytes) {
  if (kSanitized) return;
  const rlimit limit{addressSpace() + kSpareBytes + kDeflateAtBest * fileBytes, RLIM_INFINITY};
  setrlimit(RLIMIT_AS, &limit);
}

void fail(Shared& shared, const std::string& what) {
  std::snprintf(shared.failure, sizeof shared.failure, "%s", what.c_str());
}

/// One mutant; false if something is wrong with what became of it.
bool tryMutant(const FuzzTarget& target, const std::filesystem::path& file, std::size_t bytes,
               Shared& shared) {
  largestRequest = 0;
  const auto start = std::chrono::steady_clock::now();
  try {
    target.read(file);
    ++shared.read;
  } catch (const InputError& error) {
    ++shared.refused;
    if (std::strchr(error.what(), '\n'))
      return fail(shared, std::string("an error of several lines: ") + error.what()), false;
  } catch (const std::exception& error) {
    return fail(shared, std::string("threw ") + error.what()), false;
  }
  const double ms =
      std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count();
  shared.slowestMs = std::max(shared.slowestMs, ms);
  const double mb = static_cast<double>(largestRequest.load()) / (1 << 20);
  shared.largestMb = std::max(shared.largestMb, mb);
  // What the file's bytes could hold, as labels, numbers and their displays: 16 bytes for each unpacked one.
  if (!kSanitized && largestRequest > 16 * kDeflateAtBest * bytes + (std::size_t{16} << 20))
    return fail(shared,
                "asked for " + std::to_string(mb) + " MB at once for " + std::to_string(bytes) + " bytes"),
           false;
  return true;
}

/// Runs in the child, to its end.
void runMutants(const FuzzTarget& target, int count, unsigned seed, const std::filesystem::path& keep,
                Shared& shared) {
  const TemporaryFolder folder;
  const std::string good = target.sample(folder.path());
  MemoryFile memory(folder / target.fileName);
  const std::size_t most = 2 * good.size() + 10000;  // detached voxels and neighbours count as well
  target.read(memory.write(good));                   // the good file must be good; starts all threads
  limitMemory(most);
  std::mt19937 draw(seed);
  for (int m = 0; m < count; ++m) {
    shared.mutant = m;
    const std::string bytes = mutated(good, draw);
    if (!keep.empty()) std::ofstream(keep / (target.name + ".mutant"), std::ios::binary) << bytes;
    if (!tryMutant(target, memory.write(bytes), most, shared)) return;
  }
  shared.finished = true;
}

/// Waits for the child; kills it if one mutant takes too long.
int watch(pid_t child, const Shared& shared, bool& hung) {
  int status = 0, last = -1;
  auto since = std::chrono::steady_clock::now();
  while (waitpid(child, &status, WNOHANG) == 0) {
    std::this_thread::sleep_for(std::chrono::milliseconds(5));
    const int now = shared.mutant;
    if (now != last) since = std::chrono::steady_clock::now();
    last = now;
    if (now < 0) continue;
    hung = std::chrono::duration<double>(std::chrono::steady_clock::now() - since).count() > kSecondsAMutant;
    if (hung) kill(child, SIGKILL);
  }
  return status;
}

}  // namespace

FuzzOutcome fuzz(const FuzzTarget& target, int count, unsigned seed, const std::filesystem::path& keep) {
  void* memory = mmap(nullptr, sizeof(Shared), PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS, -1, 0);
  if (memory == MAP_FAILED) throw std::runtime_error("no shared memory");
  auto& shared = *new (memory) Shared{};
  shared.mutant = -1;
  std::fflush(nullptr);
  const pid_t child = fork();
  if (child < 0) throw std::runtime_error("cannot start a process");
  if (child == 0) {
    try {
      runMutants(target, count, seed, keep, shared);
    } catch (const std::exception& error) {
      fail(shared, std::string("the good file: ") + error.what());
    }
    std::_Exit(0);
  }
  bool hung = false;
  const int status = watch(child, shared, hung);
  FuzzOutcome outcome{shared.read, shared.refused, shared.failure, shared.slowestMs, shared.largestMb};
  if (outcome.failure.empty() && hung)
    outcome.failure = "took more than " + std::to_string(kSecondsAMutant) + " s";
  if (outcome.failure.empty() && WIFSIGNALED(status))
    outcome.failure = "crashed with signal " + std::to_string(WTERMSIG(status));
  if (outcome.failure.empty() && !shared.finished) outcome.failure = "ended the program";
  if (!outcome.failure.empty())
    outcome.failure = target.name + ", seed " + std::to_string(seed) + ", mutant " +
                      std::to_string(shared.mutant.load()) + ": " + outcome.failure;
  munmap(memory, sizeof(Shared));
  return outcome;
}

}  // namespace falciform::test
