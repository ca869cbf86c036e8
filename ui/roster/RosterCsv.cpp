#include "ui/roster/RosterCsv.h"

#include <QCoreApplication>
#include <QHash>
#include <QStringDecoder>
#include <algorithm>
#include <array>

namespace sagara::ui::roster {
namespace {

constexpr qsizetype kMostBytes = 4 * 1024 * 1024;  // some 50 000 people
constexpr std::array kColumns{"name", "number", "rank", "class", "note"};

QString text(const char* source) { return QCoreApplication::translate("roster", source); }

/// A line of the file as fields; `line` is where it begins.
struct CsvRecord {
    int line = 1;
    QStringList fields;
    bool openQuote = false;  ///< the file ended within quotes
};

class Reader final {
public:
    Reader(const QString& all, QChar delimiter) : m_all(all), m_delimiter(delimiter) {}

    bool atEnd() const { return m_at >= m_all.size(); }
    CsvRecord next() {
        CsvRecord record;
        record.line = m_line;
        for (;;) {
            record.fields.append(field(record.openQuote));
            if (atEnd()) return record;
            const QChar c = m_all[m_at++];
            if (c == m_delimiter) {
                if (atEnd()) record.fields.append(QString());
                continue;
            }
            ++m_line;
            if (c == QLatin1Char('\r') && !atEnd() && m_all[m_at] == QLatin1Char('\n')) ++m_at;
            return record;
        }
    }

private:
    bool endsField(QChar c) const {
        return c == m_delimiter || c == QLatin1Char('\n') || c == QLatin1Char('\r');
    }
    QString field(bool& openQuote) {
        QString words;
        qsizetype ahead = m_at;
        while (ahead < m_all.size() && m_all[ahead] == QLatin1Char(' ')) ++ahead;
        if (ahead < m_all.size() && m_all[ahead] == QLatin1Char('"')) {
            m_at = ahead + 1;
            words = quoted(openQuote);
        }
        while (!atEnd() && !endsField(m_all[m_at])) words += m_all[m_at++];
        return words;
    }
    QString quoted(bool& openQuote) {
        QString words;
        while (!atEnd()) {
            const QChar c = m_all[m_at++];
            if (c == QLatin1Char('"')) {
                if (atEnd() || m_all[m_at] != QLatin1Char('"')) return words;
                ++m_at;
            }
            if (c == QLatin1Char('\n')) ++m_line;
            words += c;
        }
        openQuote = true;
        return words;
    }

    const QString& m_all;
    QChar m_delimiter;
    qsizetype m_at = 0;
    int m_line = 1;
};

/// Of the first line, outside quotes, the most frequent.
QChar delimiterOf(const QString& all) {
    QHash<QChar, int> counts;
    bool inQuotes = false;
    for (const QChar c : all) {
        if (!inQuotes && (c == QLatin1Char('\n') || c == QLatin1Char('\r'))) break;
        if (c == QLatin1Char('"')) inQuotes = !inQuotes;
        if (!inQuotes) ++counts[c];
    }
    QChar best = QLatin1Char(',');
    for (const QChar c : {QLatin1Char(';'), QLatin1Char('\t')})
        if (counts.value(c) > counts.value(best)) best = c;
    return best;
}

/// Where each of kColumns is in the file, or -1.
using Places = std::array<qsizetype, kColumns.size()>;

core::Result<Places, QString> placesOf(const QStringList& header, QStringList& ignored) {
    Places places;
    places.fill(-1);
    for (qsizetype i = 0; i < header.size(); ++i) {
        const QString title = header[i].trimmed();
        const auto known = std::find_if(kColumns.begin(), kColumns.end(), [&](const char* column) {
            return title.compare(QLatin1String(column), Qt::CaseInsensitive) == 0;
        });
        if (known == kColumns.end()) {
            if (!title.isEmpty()) ignored.append(title);
            continue;
        }
        qsizetype& place = places[static_cast<std::size_t>(known - kColumns.begin())];
        if (place >= 0) return text("Line 1 names the column \"%1\" twice, expected it once.").arg(title);
        place = i;
    }
    if (places[0] < 0)
        return text(
                   "Line 1 has no column \"name\" but \"%1\", expected the names of the columns: name, "
                   "number, rank, class, note, in any order; only name must be there.")
            .arg(header.join(QStringLiteral("\", \"")));
    return places;
}

QString valueAt(const QStringList& fields, qsizetype place) {
    return place >= 0 && place < fields.size() ? fields[place].trimmed() : QString();
}

QString firstFault(const Person& p) {
    for (const QString& fault : {nameFault(p.name), numberFault(p.number), rankFault(p.rank),
                                 classFault(p.className), noteFault(p.note)})
        if (!fault.isEmpty()) return fault;
    return {};
}

CsvRow rowOf(const CsvRecord& record, const Places& places, qsizetype columns) {
    CsvRow row;
    row.line = record.line;
    row.person.name = valueAt(record.fields, places[0]);
    row.person.number = valueAt(record.fields, places[1]);
    row.person.rank = valueAt(record.fields, places[2]);
    row.person.className = valueAt(record.fields, places[3]);
    row.person.note = valueAt(record.fields, places[4]);
    if (record.openQuote) {
        row.fault = text("a quotation mark is not closed, expected one at the end of the field");
    } else if (record.fields.size() != columns) {
        row.fault = text("%1 fields found, expected %2 as in line 1").arg(record.fields.size()).arg(columns);
    } else {
        row.fault = firstFault(row.person);
    }
    return row;
}

bool isBlank(const CsvRecord& record) {
    return std::all_of(record.fields.begin(), record.fields.end(),
                       [](const QString& field) { return field.trimmed().isEmpty(); });
}

/// Up to so many characters on one line; `what` is the start of the sentence.
QString lineFault(const QString& words, int longest, const QString& what) {
    const bool control =
        std::any_of(words.begin(), words.end(), [](QChar c) { return c.category() == QChar::Other_Control; });
    if (control)
        return text("%1 goes over several lines or holds control characters, expected one line").arg(what);
    const auto length = words.toUcs4().size();
    if (length > longest)
        return text("%1 has %2 characters, expected up to %3").arg(what).arg(length).arg(longest);
    return {};
}

QString quotedField(const QString& words) {
    const bool plain = std::none_of(words.begin(), words.end(), [](QChar c) {
        return c == QLatin1Char(',') || c == QLatin1Char(';') || c == QLatin1Char('"') ||
               c == QLatin1Char('\n') || c == QLatin1Char('\r') || c == QLatin1Char('\t');
    });
    if (plain) return words;
    return QLatin1Char('"') + QString(words).replace(QLatin1Char('"'), QStringLiteral("\"\"")) +
           QLatin1Char('"');
}

}  // namespace

core::Result<CsvList, QString> readCsv(const QByteArray& bytes) {
    if (bytes.size() > kMostBytes)
        return text("The file has %1 MB, expected a list of people of up to 4 MB.")
            .arg(bytes.size() / (1024 * 1024));
    QStringDecoder decoder(QStringDecoder::Utf8);
    const QString all = decoder(bytes);
    if (decoder.hasError() || all.contains(QChar::Null))
        return text("The file is not UTF-8. In the spreadsheet, save it as \"CSV UTF-8\".");
    if (all.trimmed().isEmpty())
        return text(
            "The file is empty, expected a first line with the names of the columns: name, number, "
            "rank, class, note.");
    CsvList list;
    list.delimiter = delimiterOf(all);
    Reader reader(all, list.delimiter);
    const QStringList header = reader.next().fields;
    const auto places = placesOf(header, list.ignored);
    if (!places) return places.error();
    while (!reader.atEnd()) {
        const CsvRecord record = reader.next();
        if (!isBlank(record)) list.rows.push_back(rowOf(record, *places, header.size()));
    }
    if (list.rows.empty()) return text("The file names no people: there is nothing below its first line.");
    return list;
}

void markDuplicates(std::vector<CsvRow>& rows, const std::vector<Person>& roster) {
    QHash<QString, QString> names, numbers;
    const auto remember = [&](const Person& p, const QString& where) {
        names.insert(p.name, where);
        if (!p.number.isEmpty()) numbers.insert(p.number, where);
    };
    for (const Person& p : roster)
        if (!p.retired) remember(p, text("%1 on the roster").arg(p.name));
    for (CsvRow& row : rows) {
        row.duplicate.clear();
        if (!row.fault.isEmpty()) continue;
        if (names.contains(row.person.name)) {
            row.duplicate = text("same name as %1").arg(names.value(row.person.name));
        } else if (numbers.contains(row.person.number)) {
            row.duplicate = text("same number as %1").arg(numbers.value(row.person.number));
        } else {
            remember(row.person, text("line %1").arg(row.line));
        }
    }
}

QString nameFault(const QString& name) {
    if (name.trimmed().isEmpty()) return text("the name is empty, expected 1 to 80 characters");
    return lineFault(name.trimmed(), 80, text("the name"));
}
QString numberFault(const QString& number) { return lineFault(number.trimmed(), 40, text("the number")); }
QString rankFault(const QString& rank) { return lineFault(rank.trimmed(), 40, text("the rank")); }
QString classFault(const QString& name) { return lineFault(name.trimmed(), 80, text("the class")); }
QString noteFault(const QString& note) { return lineFault(note.trimmed(), 400, text("the note")); }

QByteArray writeCsv(const std::vector<Person>& people) {
    QString all = QStringLiteral("\uFEFFname,number,rank,class,note\r\n");
    for (const Person& p : people) {
        QStringList fields;
        for (const QString& words : {p.name, p.number, p.rank, p.className, p.note})
            fields.append(quotedField(words));
        all += fields.join(QLatin1Char(',')) + QStringLiteral("\r\n");
    }
    return all.toUtf8();
}

}  // namespace sagara::ui::roster
