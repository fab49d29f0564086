#pragma once

// What a declaration must refuse.

#include <velarium/error.hpp>

#include <gtest/gtest.h>

#include <string>

namespace velarium::graph {

template <class Deed>
void expect_internal_error(const Deed& deed, const std::string& part_of_message) {
  try {
    deed();
    FAIL() << "nothing was thrown";
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), ErrorCode::internal);
    EXPECT_NE(std::string(error.what()).find(part_of_message), std::string::npos) << error.what();
  }
}

}  // namespace velarium::graph
