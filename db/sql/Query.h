#pragma once

#include <QSqlQuery>
#include <QVariant>
#include <bit>
#include <concepts>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <type_traits>

#include "core/base/Utc.h"
#include "db/DbError.h"
#include "db/sql/Connection.h"

namespace sagara::db {

/// Bytes that must come back as they are (documents): bound as a BLOB, so write `CAST(? AS TEXT)` and read
/// `CAST(x AS BLOB)`. Other text passes through QString, which mends invalid UTF-8 and drops a byte order
/// mark.
struct Bytes {
    std::string_view bytes;
};

/// Keys of tables: `enum class RunId : std::int64_t {}`.
template <typename T>
concept Id = std::is_enum_v<T> && std::same_as<std::underlying_type_t<T>, std::int64_t>;

inline QVariant toVariant(bool value) { return value ? 1 : 0; }
inline QVariant toVariant(int value) { return value; }
inline QVariant toVariant(std::int64_t value) { return QVariant::fromValue<qlonglong>(value); }
inline QVariant toVariant(double value) { return value; }
QVariant toVariant(std::string_view text);
inline QVariant toVariant(const std::string& text) { return toVariant(std::string_view(text)); }
QVariant toVariant(const char* text) = delete;  // would become bool
QVariant toVariant(Bytes bytes);
inline QVariant toVariant(core::Utc instant) { return toVariant(core::formatUtc(instant)); }
inline QVariant toVariant(Id auto id) { return toVariant(static_cast<std::int64_t>(id)); }
template <typename T>
QVariant toVariant(const std::optional<T>& value) {
    return value ? toVariant(*value) : QVariant();
}

/// SQLite integers have a sign; the bits are kept.
inline std::int64_t signedBits(std::uint64_t value) { return std::bit_cast<std::int64_t>(value); }
inline std::uint64_t unsignedBits(std::int64_t value) { return std::bit_cast<std::uint64_t>(value); }

/// One statement, run when made, its `?` bound in order. Then it is a cursor: next(), and the columns of that
/// row by name. Every failure is a DbError. Keep it no longer than the rows are read: an open SELECT holds
/// its snapshot.
class Query final {
public:
    template <typename... Values>
    Query(Connection& connection, const QString& sql, const Values&... values)
        : Query(Run{}, connection, sql, QVariantList{toVariant(values)...}) {}

    bool next();
    std::int64_t changedRows() const { return m_query.numRowsAffected(); }
    std::int64_t newId() const { return m_query.lastInsertId().toLongLong(); }

    std::int64_t integer(const QString& column) const { return value(column).toLongLong(); }
    double real(const QString& column) const { return value(column).toDouble(); }
    bool flag(const QString& column) const { return integer(column) != 0; }
    std::string text(const QString& column) const { return value(column).toString().toStdString(); }
    std::string bytes(const QString& column) const { return value(column).toByteArray().toStdString(); }
    bool isNull(const QString& column) const { return value(column).isNull(); }
    core::Utc utc(const QString& column) const;
    std::uint64_t hash(const QString& column) const;  ///< of 16 hexadecimal digits
    template <Id T>
    T id(const QString& column) const {
        return static_cast<T>(integer(column));
    }
    /// The text as one value of an enumeration, by its `parse` function.
    template <typename Parse>
    auto word(const QString& column, Parse&& parse) const {
        const auto parsed = parse(text(column));
        if (!parsed) throw unexpected(column);
        return *parsed;
    }

private:
    struct Run {};
    Query(Run, Connection& connection, const QString& sql, const QVariantList& values);
    QVariant value(const QString& column) const;
    DbError unexpected(const QString& column) const;

    Connection& m_connection;
    QSqlQuery m_query;
};

/// A statement without rows to read; gives how many it changed.
template <typename... Values>
std::int64_t execute(Connection& connection, const QString& sql, const Values&... values) {
    return Query(connection, sql, values...).changedRows();
}

}  // namespace sagara::db
