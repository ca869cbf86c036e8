#pragma once

namespace sagara::db {

class Connection;
class Database;

/// All or nothing: rolled back unless committed. Takes the write lock at once, so two writers wait for each
/// other instead of failing half way. One within another is a savepoint: it is undone alone, or with the
/// outer one.
class Transaction final {
public:
    explicit Transaction(Database& db);
    explicit Transaction(Connection& connection);
    ~Transaction();
    Transaction(const Transaction&) = delete;
    Transaction& operator=(const Transaction&) = delete;

    void commit();

private:
    Connection& m_connection;
    int m_depth;  ///< 0 is the outermost
    bool m_open = true;
};

}  // namespace sagara::db
