#include "db/sql/Line.h"

#include <QList>
#include <algorithm>

namespace sagara::db {
namespace {

bool hasControlCharacter(const QString& text) {
    return std::any_of(text.begin(), text.end(),
                       [](QChar c) { return c.category() == QChar::Other_Control; });
}

}  // namespace

Line checkedLine(std::string_view typed, int longest_characters) {
    const QString all = QString::fromUtf8(typed.data(), qsizetype(typed.size()));
    const QString text = all.trimmed();
    // Bytes that are not UTF-8 come back as replacement characters.
    if (all.toStdString() != typed || hasControlCharacter(text)) return {{}, LineFault::Unreadable};
    if (text.isEmpty()) return {{}, LineFault::Empty};
    if (text.toUcs4().size() > longest_characters) return {{}, LineFault::TooLong};
    return {text.toStdString(), LineFault::None};
}

}  // namespace sagara::db
