#include "db/Transaction.h"

#include <cassert>

#include "db/Database.h"
#include "db/sql/Query.h"

namespace sagara::db {
namespace {

using namespace Qt::StringLiterals;

QString begin(int depth) { return depth == 0 ? u"BEGIN IMMEDIATE"_s : u"SAVEPOINT level_%1"_s.arg(depth); }
QString keep(int depth) { return depth == 0 ? u"COMMIT"_s : u"RELEASE level_%1"_s.arg(depth); }
QString undo(int depth) { return depth == 0 ? u"ROLLBACK"_s : u"ROLLBACK TO level_%1"_s.arg(depth); }

/// SQLite has already rolled back after some failures (disk full, for one); then these have nothing left to
/// do.
void tryTo(Connection& connection, const QString& sql) {
    try {
        execute(connection, sql);
    } catch (const DbError&) {
    }
}

}  // namespace

Transaction::Transaction(Database& db) : Transaction(db.connection()) {}

Transaction::Transaction(Connection& connection)
    : m_connection(connection), m_depth(connection.openTransactions()) {
    execute(m_connection, begin(m_depth));
    m_connection.setOpenTransactions(m_depth + 1);
}

Transaction::~Transaction() {
    if (!m_open) return;
    tryTo(m_connection, undo(m_depth));
    if (m_depth > 0)
        tryTo(m_connection, keep(m_depth));  // ROLLBACK TO leaves the savepoint itself on the stack
    m_connection.setOpenTransactions(m_depth);
}

void Transaction::commit() {
    assert(m_open && m_connection.openTransactions() == m_depth + 1);
    execute(m_connection, keep(m_depth));
    m_open = false;
    m_connection.setOpenTransactions(m_depth);
}

}  // namespace sagara::db
