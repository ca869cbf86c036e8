#pragma once

#include <filesystem>
#include <memory>
#include <string>

namespace sagara::db {
class Connection;
}

namespace sagara::run::test {

/// A connection of this test to a database that sagara-sim uses, too.
class Sqlite final {
public:
    explicit Sqlite(const std::filesystem::path& file);
    ~Sqlite();
    Sqlite(const Sqlite&) = delete;
    Sqlite& operator=(const Sqlite&) = delete;

    void execute(const char* sql);
    /// First column of the first row as text; "" when there is none.
    std::string value(const char* sql);

private:
    std::unique_ptr<db::Connection> m_connection;
};

}  // namespace sagara::run::test
