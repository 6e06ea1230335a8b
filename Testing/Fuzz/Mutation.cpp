#include "Testing/Fuzz/Mutation.h"

#include <algorithm>

namespace falciform::test {

std::string mutated(std::string bytes, std::mt19937& draw) {
  using namespace std::string_literals;
  const auto below = [&](std::size_t n) { return n == 0 ? 0 : static_cast<std::size_t>(draw()) % n; };
  const auto somewhere = [&] {
    return below(draw() % 2 ? bytes.size() : std::min<std::size_t>(bytes.size(), 400));
  };
  const std::string extremes[] = {"\xff\xff\xff\x7f"s,
                                  "\xff\xff\xff\xff"s,
                                  "\x00\x00\x00\x80"s,
                                  "\x00\x00\x00\x00"s,
                                  "\xff\xff"s,
                                  "\x00\x80"s,
                                  "\x00\x00\x00\x10"s,
                                  "9999"s,
                                  "1e99"s,
                                  "-1"s,
                                  "nan "s};
  for (std::size_t changes = 1 + below(6); changes > 0 && !bytes.empty(); --changes) {
    const std::size_t at = somewhere();
    switch (draw() % 10) {
      case 0:
        bytes[at] = static_cast<char>(draw());
        break;
      case 1:
        bytes[at] = static_cast<char>(bytes[at] ^ (1 << draw() % 8));
        break;
      case 2:
        bytes[at] = "0019-.()=: \n\\"[draw() % 13];
        break;  // what text headers are made of
      case 3:
        bytes.resize(draw() % 3 ? bytes.size() - below(std::min<std::size_t>(bytes.size(), 64)) : at);
        break;
      case 4:
        bytes.insert(at, below(20), static_cast<char>(draw()));
        break;
      case 5:
        bytes.erase(at, below(20));
        break;
      case 6:
        bytes.insert(at, bytes.substr(somewhere(), below(40)));
        break;
      case 7:
      case 8: {
        const std::string& extreme = extremes[draw() % std::size(extremes)];
        bytes.replace(at, std::min(extreme.size(), bytes.size() - at), extreme);
        break;
      }
      default:  // a digit: counts and sizes of text headers
        if (const std::size_t digit = bytes.find_first_of("0123456789", at); digit != std::string::npos)
          bytes[digit] = static_cast<char>('0' + draw() % 10);
    }
  }
  return bytes;
}

}  // namespace falciform::test
