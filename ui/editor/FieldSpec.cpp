#include "ui/editor/FieldSpec.h"

#include <QCoreApplication>
#include <algorithm>
#include <utility>

namespace sagara::ui::editor {
namespace {

Field made(std::string key, QString label, FieldKind kind, QString hint) {
    Field f;
    f.key = std::move(key);
    f.label = std::move(label);
    f.kind = kind;
    f.hint = std::move(hint);
    return f;
}

}  // namespace

const Variant* ListSpec::variantOf(const Json& row) const {
    if (variants.empty()) return nullptr;
    if (kindKey.empty()) {
        for (const Variant& v : variants)
            if (find(row, v.value)) return &v;
        return &variants.back();
    }
    const std::string kind = textAt(row, kindKey);
    const auto it =
        std::find_if(variants.begin(), variants.end(), [&](const Variant& v) { return v.value == kind; });
    return it == variants.end() ? nullptr : &*it;
}

std::vector<Field> ListSpec::fieldsOf(const Json& row) const {
    std::vector<Field> all = common;
    if (const Variant* variant = variantOf(row))
        all.insert(all.end(), variant->fields.begin(), variant->fields.end());
    return all;
}

const Field* ListSpec::field(const std::string& key) const {
    for (const Field& f : common)
        if (f.key == key) return &f;
    return nullptr;
}

QString words(const char* text) { return QCoreApplication::translate("editor", text); }

std::string freshName(const std::string& name, const std::set<std::string>& taken) {
    if (!taken.contains(name)) return name;
    const std::size_t last = name.find_last_not_of("0123456789");
    const bool numbered = last != std::string::npos && last + 1 < name.size();
    const std::string base = numbered ? name.substr(0, last + 1) : name + " ";
    int number = 2;
    while (taken.contains(base + std::to_string(number))) ++number;
    return base + std::to_string(number);
}

Field text(std::string key, QString label, QString hint, QString initial) {
    Field f = made(std::move(key), std::move(label), FieldKind::Text, std::move(hint));
    f.initial = initial.toStdString();
    return f;
}

Field longText(std::string key, QString label, QString hint) {
    return made(std::move(key), std::move(label), FieldKind::LongText, std::move(hint));
}

Field idField(QString hint) { return made("id", words("Id"), FieldKind::Id, std::move(hint)); }

Field number(std::string key, QString label, double low, double high, QString unit, QString hint,
             Json initial) {
    Field f = made(std::move(key), std::move(label), FieldKind::Number, std::move(hint));
    f.low = low;
    f.high = high;
    f.unit = std::move(unit);
    f.initial = std::move(initial);
    return f;
}

Field integer(std::string key, QString label, int low, int high, QString hint, Json initial) {
    Field f = number(std::move(key), std::move(label), low, high, {}, std::move(hint), std::move(initial));
    f.kind = FieldKind::Integer;
    return f;
}

Field flag(std::string key, QString label, QString hint) {
    return optional(made(std::move(key), std::move(label), FieldKind::Flag, std::move(hint)));
}

Field choice(std::string key, QString label, std::vector<Option> options, QString hint) {
    Field f = made(std::move(key), std::move(label), FieldKind::Choice, std::move(hint));
    if (!options.empty()) f.initial = options.front().value;
    f.options = std::move(options);
    return f;
}

Field reference(std::string key, QString label, Source source, QString hint) {
    Field f = made(std::move(key), std::move(label), FieldKind::Reference, std::move(hint));
    f.source = source;
    return f;
}

Field references(std::string key, QString label, Source source, QString hint) {
    Field f = made(std::move(key), std::move(label), FieldKind::References, std::move(hint));
    f.source = source;
    return f;
}

Field position(std::string key, QString label, QString hint) {
    return made(std::move(key), std::move(label), FieldKind::Position, std::move(hint));
}

Field place(std::string key, QString label, QString hint) {
    return made(std::move(key), std::move(label), FieldKind::Place, std::move(hint));
}

Field places(std::string key, QString label, std::size_t count, QString hint) {
    Field f = made(std::move(key), std::move(label), FieldKind::Places, std::move(hint));
    f.count = count;
    return f;
}

Field numbers(std::string key, QString label, std::size_t count, double low, double high, QString unit,
              QString hint, Json initial) {
    Field f = number(std::move(key), std::move(label), low, high, std::move(unit), std::move(hint),
                     std::move(initial));
    f.kind = FieldKind::Numbers;
    f.count = count;
    return f;
}

Field list(std::string key, QString label, ListSpec spec, QString hint) {
    Field f = made(std::move(key), std::move(label), FieldKind::List, std::move(hint));
    f.list = std::make_shared<const ListSpec>(std::move(spec));
    return f;
}

Field optional(Field field) {
    field.optional = true;
    return field;
}

}  // namespace sagara::ui::editor
