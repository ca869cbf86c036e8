#pragma once

#include <QByteArray>
#include <QString>
#include <QStringList>
#include <vector>

#include "core/base/Result.h"
#include "ui/roster/RosterTypes.h"

namespace sagara::ui::roster {

/// One person of a file, and what speaks against taking them in.
struct CsvRow {
    int line = 0;  ///< of the file, 1 is the first; where the person begins
    Person person;
    QString fault;      ///< what was found and what is accepted; empty: nothing
    QString duplicate;  ///< who is the same; empty: nobody
    bool usable() const { return fault.isEmpty() && duplicate.isEmpty(); }
};

struct CsvList {
    std::vector<CsvRow> rows;
    QStringList ignored;  ///< columns that are of no use here
    QChar delimiter;
};

/// A list of people as a spreadsheet writes it: UTF-8 with or without a byte order mark; commas, semicolons
/// or tabs; quotes as in RFC 4180. The first line names the columns, in any order and case: name, number,
/// rank, class, note; only name must be there. Every line that is no person is in the list with its fault.
/// The error is of the file as a whole.
core::Result<CsvList, QString> readCsv(const QByteArray& bytes);

/// Marks those who have the name or the number of somebody on the roster or further up in the file.
void markDuplicates(std::vector<CsvRow>& rows, const std::vector<Person>& roster);

/// What is wrong with a person as typed, or empty; the same rules as the database's.
QString nameFault(const QString& name);
QString numberFault(const QString& number);
QString rankFault(const QString& rank);
QString classFault(const QString& name);
QString noteFault(const QString& note);

/// UTF-8 with a byte order mark, commas, lines that end as in RFC 4180: readCsv gives the same people again.
QByteArray writeCsv(const std::vector<Person>& people);

}  // namespace sagara::ui::roster
