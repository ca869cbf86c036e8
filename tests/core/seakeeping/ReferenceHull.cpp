#include "ReferenceHull.h"

#include "tests/support/ReferenceCsv.h"

namespace sagara::core {

HullForm referenceHull(const std::string& name) {
    return readHullForm(name, test::readReferenceText("seakeeping/" + name + "_hull.json")).value();
}

}  // namespace sagara::core
