#pragma once

#include <velarium/options.hpp>

#include <sstream>
#include <string>

namespace velarium::test {

// Sets options from words "key=value" with spaces between, as tables of tests hold them.
inline void set_options(Settings& settings, const std::string& words) {
  std::istringstream in(words);
  for (std::string word; in >> word;) {
    const auto equals = word.find('=');
    set_option(settings, word.substr(0, equals), word.substr(equals + 1));
  }
}

}  // namespace velarium::test
