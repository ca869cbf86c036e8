#include "Sqlite.h"

#include <gtest/gtest.h>

#include <QCoreApplication>
#include <QSqlQuery>
#include <optional>

#include "db/Database.h"
#include "db/sql/Query.h"

namespace sagara::run::test {
namespace {

/// Qt finds its SQL drivers through the application object.
class QtEnvironment final : public ::testing::Environment {
public:
    void SetUp() override { m_application.emplace(m_count, m_arguments); }
    void TearDown() override { m_application.reset(); }

private:
    char m_name[13] = "test_app_run";
    char* m_arguments[2] = {m_name, nullptr};
    int m_count = 1;
    std::optional<QCoreApplication> m_application;
};

[[maybe_unused]] const auto* const kQt = ::testing::AddGlobalTestEnvironment(new QtEnvironment);

}  // namespace

Sqlite::Sqlite(const std::filesystem::path& file)
    : m_connection(
          std::make_unique<db::Connection>(file, db::Connection::Access::ReadWrite, db::kBusyTimeout)) {}
Sqlite::~Sqlite() = default;

void Sqlite::execute(const char* sql) { db::execute(*m_connection, QString::fromUtf8(sql)); }

std::string Sqlite::value(const char* sql) {
    QSqlQuery query(QString::fromUtf8(sql), m_connection->handle());
    return query.next() ? query.value(0).toString().toStdString() : "";
}

}  // namespace sagara::run::test
