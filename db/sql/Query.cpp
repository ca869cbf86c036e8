#include "db/sql/Query.h"

#include <QSqlRecord>
#include <cassert>

#include "db/sql/Failure.h"

namespace sagara::db {
namespace {

/// A string_view may be made of no pointer at all, which Qt would store as NULL.
const char* addressOf(std::string_view text) { return text.data() ? text.data() : ""; }

}  // namespace

QVariant toVariant(std::string_view text) {
    return QString::fromUtf8(addressOf(text), qsizetype(text.size()));
}
QVariant toVariant(Bytes bytes) { return QByteArray(addressOf(bytes.bytes), qsizetype(bytes.bytes.size())); }

Query::Query(Run, Connection& connection, const QString& sql, const QVariantList& values)
    : m_connection(connection), m_query(connection.handle()) {
    m_connection.requireInPlace();
    m_query.setForwardOnly(true);
    if (!m_query.prepare(sql)) throw failure(m_connection, m_query.lastError());
    for (const QVariant& value : values) m_query.addBindValue(value);
    if (!m_query.exec()) throw failure(m_connection, m_query.lastError());
}

bool Query::next() {
    if (m_query.next()) return true;
    if (m_query.lastError().isValid()) throw failure(m_connection, m_query.lastError());
    return false;
}

core::Utc Query::utc(const QString& column) const { return word(column, core::parseUtc); }

std::uint64_t Query::hash(const QString& column) const {
    bool isHex = false;
    const std::uint64_t hash = value(column).toString().toULongLong(&isHex, 16);
    if (!isHex) throw unexpected(column);
    return hash;
}

QVariant Query::value(const QString& column) const {
    assert(m_query.record().indexOf(column) >= 0);
    return m_query.value(column);
}

DbError Query::unexpected(const QString& column) const {
    return problem(
        DbError::Kind::Damaged, m_connection.file(),
        "column " + column.toStdString() + " holds '" + text(column) + "', which has no meaning here");
}

}  // namespace sagara::db
