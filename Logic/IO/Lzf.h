#pragma once
#include <optional>
#include <string>
#include <string_view>

namespace falciform {

/// LZF data (Marc Lehmann's liblzf format, as in binary_compressed PCD) unpacked to exactly `size` bytes;
/// nothing if they are damaged or of another size. Inside Logic/IO only.
[[nodiscard]] std::optional<std::string> unpackLzf(std::string_view packed, std::size_t size);

/// The same bytes as literals, no shorter but valid: for tests.
[[nodiscard]] std::string packLzfLiterally(std::string_view bytes);

}  // namespace falciform
