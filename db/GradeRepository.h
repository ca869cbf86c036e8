#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "core/base/Utc.h"
#include "db/RunRepository.h"

namespace sagara::db {

struct Grade {
    double score = 0.0;  ///< 0 to 100
    bool passed = false;
    std::string tasks = "[]";       ///< JSON
    std::string deductions = "[]";  ///< JSON
    bool advisory = true;           ///< every automatic grade is; only a trainer's own is not
    core::Utc made;
    friend bool operator==(const Grade&, const Grade&) = default;
};

/// Grades of runs, at most one each. All SQL about table `grade` is in this class's .cpp file.
class GradeRepository final {
public:
    explicit GradeRepository(Database& db) : m_db(db) {}

    void put(RunId run, const Grade& grade);  ///< replaces the run's grade
    std::optional<Grade> find(RunId run) const;

private:
    Database& m_db;  ///< outlives every repository
};

}  // namespace sagara::db
