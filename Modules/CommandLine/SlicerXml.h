#pragma once
#include <string>

#include "Modules/CommandLine/Arguments.h"

namespace falciform::commandline {

/// The description from which 3D Slicer builds a module's form.
[[nodiscard]] std::string slicerXml(const Syntax& syntax);

/// `&`, `<`, `>` and quotes as entities, for XML and HTML.
[[nodiscard]] std::string escaped(const std::string& text);

}  // namespace falciform::commandline
