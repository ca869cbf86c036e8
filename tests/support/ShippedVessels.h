#pragma once

#include <string>
#include <vector>

namespace sagara::test {

/// Ids of all documents in assets/vessels, in alphabetical order.
std::vector<std::string> shippedVessels();
/// An id as the name of a parameterised test.
std::string testName(std::string vessel);

}  // namespace sagara::test
