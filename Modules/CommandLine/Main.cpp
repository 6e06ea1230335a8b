#include <unistd.h>

#include <cstdlib>
#include <filesystem>
#include <iostream>
#include <new>

#include "Logic/Biomechanics/BlasKernel.h"
#include "Logic/Core/Parallel.h"
#include "Logic/IO/VolumeFiles.h"
#include "Modules/CommandLine/Commands.h"
#include "Modules/CommandLine/HelpText.h"
#include "Modules/CommandLine/ReturnParameters.h"
#include "Modules/CommandLine/SlicerXml.h"
#include "Modules/CommandLine/TerminalProgress.h"
#include "Version.h"

namespace falciform::commandline {
namespace {

enum ExitCode { kDone = 0, kOwnFault = 1, kInputOrUsage = 2, kCancelled = 130 };

/// Of a free text (a list of methods, say) only what leads to a place that is there can name a folder.
bool mayNamePlace(const Argument* argument, const std::filesystem::path& given) {
  if (argument == nullptr || argument->kind != ArgumentKind::Text) return true;
  std::error_code ignored;
  return std::filesystem::exists(given, ignored) || std::filesystem::exists(given.parent_path(), ignored);
}

/// The call as typed, folders left out: they may name a patient.
std::string callWithoutFolders(const Syntax& syntax, const std::vector<std::string>& words) {
  std::string text = "falciform";
  const Argument* argument = nullptr;
  for (const std::string& word : words) {
    const bool flag = word.starts_with("--");
    const std::size_t equals = flag ? word.find('=') : std::string::npos;
    if (flag) argument = syntax.find(word.substr(2, equals == std::string::npos ? equals : equals - 2));
    const std::string head = equals == std::string::npos ? "" : word.substr(0, equals + 1);
    std::string tail = word.substr(head.size());
    // A DICOM folder is often named after its patient.
    if (const std::filesystem::path given = tail; !isVolumeFile(given) && isDicom(given)) {
      tail = "DICOM";
    } else if (tail.find('/') != std::string::npos && mayNamePlace(argument, tail)) {
      const std::filesystem::path path = given.lexically_normal();
      tail = (path.has_filename() ? path : path.parent_path()).filename().string();
    }
    text += " " + head + tail;
    if (!flag) argument = nullptr;
  }
  return text;
}

ProgressStyle progressStyle(const ParsedArguments& arguments) {
  if (arguments.has("slicer-progress")) return ProgressStyle::Slicer;
  return !arguments.has("quiet") && isatty(STDERR_FILENO) ? ProgressStyle::Terminal : ProgressStyle::Silent;
}

void execute(const Command& command, const Syntax& syntax, const ParsedArguments& arguments,
             const std::string& call, const std::stop_source& stop) {
  setThreads(arguments.integer("threads"));
  const ProgressStyle style = progressStyle(arguments);
  CommandRun run;
  run.progress = makeProgress(style, stop.get_token());
  run.quiet = arguments.has("quiet") || style == ProgressStyle::Slicer;
  run.outputs.overwrite = arguments.has("force") ? Overwrite::Replace : Overwrite::Refuse;
  run.provenance.command = call;
  run.provenance.startedUtc = utcNow();
  if (syntax.find("seed")->kind == ArgumentKind::Integer)
    run.provenance.seed = static_cast<std::uint64_t>(arguments.integer("seed"));
  run.provenance.threads = threads();
  const bool report = arguments.has("report");
  if (report) run.outputs.announce(arguments.path("report"));
  command.run(arguments, run);
  run.progress.report(1.0, "Writing");
  if (report) run.writeSidecar(arguments.path("report"));
  run.outputs.commit();
  clearProgressLine(style);
  if (arguments.has("returnparameterfile"))
    writeTextFile(arguments.path("returnparameterfile"), Overwrite::Replace,
                  returnParameters(syntax.results(), run.figures));
  run.print();
}

void dispatch(const std::vector<std::string>& words, const std::stop_source& stop) {
  const std::string first = words.empty() ? "" : words.front();
  if (first == "--version") {
    std::cout << "falciform " << kVersion << '\n';
    return;
  }
  if (first == "--help" || first == "-h" || first == "help") {
    std::cout << overviewText();
    return;
  }
  if (words.empty()) throw InputError("no command given; see falciform --help");
  const std::string second = words.size() < 2 ? "" : words[1], both = first + " " + second;
  std::vector<std::string_view> seconds;
  for (const Command& command : commands()) {
    if (command.name.starts_with(first + " "))
      seconds.push_back(std::string_view(command.name).substr(first.size() + 1));
    if (command.name != first && command.name != both) continue;
    const Syntax syntax = syntaxOf(command);
    const ParsedArguments arguments(syntax, {words.begin() + (command.name == first ? 1 : 2), words.end()});
    if (arguments.has("help"))
      std::cout << helpText(syntax);
    else if (arguments.has("xml"))
      std::cout << slicerXml(syntax);
    else
      execute(command, syntax, arguments, callWithoutFolders(syntax, words), stop);
    return;
  }
  if (!seconds.empty() && (second == "--help" || second == "-h")) {
    std::cout << overviewText();
    return;
  }
  if (!seconds.empty())
    throw InputError("'" + first + "' wants a second word: " + listOfNames(seconds) +
                     "; see falciform --help");
  throw InputError("there is no command '" + first + "'; see falciform --help");
}

int fail(int code, std::string message) {
  // Files are written into a hidden folder first; the user knows them by their places.
  const std::string hidden = "/" + Outputs::hiddenName();
  for (std::size_t at; (at = message.find(hidden)) != std::string::npos;) message.erase(at, hidden.size());
  if (isatty(STDERR_FILENO)) std::cerr << "\r\033[K";
  for (char& c : message)
    if (c == '\n' || c == '\r') c = ' ';
  std::cerr << "falciform: " << message << std::endl;
  return code;
}

int guarded(const std::vector<std::string>& words) {
  const std::stop_source stop = stopOnSignals();
  try {
    dispatch(words, stop);
    std::cout.flush();
    if (!std::cout) return fail(kInputOrUsage, "cannot write to standard output; is the disk full?");
    return kDone;
  } catch (const InputError& error) {
    return fail(kInputOrUsage, error.what());
  } catch (const Interrupted& interrupted) {
    return fail(kCancelled, interrupted.what());
  } catch (const Cancelled&) {
    return fail(kCancelled, "cancelled; nothing was written");
  } catch (const std::filesystem::filesystem_error& error) {
    return fail(kInputOrUsage, error.what());
  } catch (const std::bad_alloc&) {
    return fail(kOwnFault, "out of memory");
  } catch (const std::exception& error) {
    return fail(kOwnFault, std::string("a fault of the program: ") + error.what());
  }
}

}  // namespace
}  // namespace falciform::commandline

int main(int count, char** values) {
  falciform::restartWithBestBlasKernel(values);
  return falciform::commandline::guarded({values + 1, values + count});
}
