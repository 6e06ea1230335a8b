#pragma once
#include <string>
#include <string_view>

#include "Logic/IO/DicomElements.h"

namespace falciform {

// What may be told of a DICOM file's texts. Inside Logic/IO only.

/// The first 16 hexadecimal digits of the SHA-256 of an identifier: equal for equal ones, and nothing else.
[[nodiscard]] std::string digestOf(std::string_view identifier);

/// A free text of `data` in UTF-8, one line, at most 64 characters, without the words of the patient's name,
/// IDs and dates, and without runs of six and more digits: these describe the patient or the day, never the
/// organ.
[[nodiscard]] std::string plainWords(const DicomItem& data, std::string_view text);

/// A code like "CT": up to 16 capitals and digits, else empty.
[[nodiscard]] std::string codeWord(std::string_view text);

}  // namespace falciform
