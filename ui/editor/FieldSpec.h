#pragma once

#include <QString>
#include <memory>
#include <vector>

#include "ui/editor/Json.h"

/// What the members of the scenario document are, for the forms: the tables are in ScenarioFields,
/// MissionFields and OrderFields. What is right and wrong is the loader's to say (core/exercise,
/// core/assess): limits stand here only to say at the field what is accepted.
namespace sagara::ui::editor {

struct Option {
    std::string value;
    QString label;
};

enum class FieldKind {
    Text,
    LongText,
    Id,
    Number,
    Integer,
    Flag,
    Choice,      ///< one of `options`
    Reference,   ///< one of what `source` has
    References,  ///< some of what `source` has; `count` of them when that is not 0
    Position,    ///< {"lat", "lon"}
    Numbers,     ///< `count` numbers; one for each shaft when that is 0
    Utc,
    List
};

/// What a reference names.
enum class Source {
    None,
    Area,
    Vessel,
    Berth,
    Bollard,
    Fairlead,
    Place,
    Ship,
    Line,
    Shaft,
    Anchor,
    Target,
    Event,
    Waypoint,
    Picture,
    Thruster
};

struct ListSpec;

struct Field {
    std::string key;  ///< "wind.speed_kn"
    QString label;
    FieldKind kind = FieldKind::Text;
    QString hint;
    bool optional = false;
    double low = 0.0;
    double high = 0.0;
    QString unit;
    std::vector<Option> options;
    Source source = Source::None;
    std::size_t count = 0;
    Json initial;  ///< in a new row; null: the first there is, or nothing
    std::shared_ptr<const ListSpec> list;
};

/// A kind of row with the members it has beside the common ones.
struct Variant {
    std::string value;
    QString label;
    std::vector<Field> fields;
};

struct ListSpec {
    QString one;  ///< "waypoint"
    std::string idBase;
    std::vector<Field> common;
    /// Names the variant; empty: it is the first whose `value` is a member of the row, else the last.
    std::string kindKey;
    std::vector<Variant> variants;
    std::vector<std::string> columns;  ///< keys; "*" is all the rest in words
    bool form = true;                  ///< the chosen row has a form below the table; else only cells
    std::size_t fixed = 0;             ///< exactly so many rows
    Json parent;                       ///< of the list, made with its first row and gone with its last

    const Variant* variantOf(const Json& row) const;
    std::vector<Field> fieldsOf(const Json& row) const;
    const Field* field(const std::string& key) const;
};

QString words(const char* text);

Field text(std::string key, QString label, QString hint, QString initial = {});
Field longText(std::string key, QString label, QString hint);
Field idField(QString hint);
Field number(std::string key, QString label, double low, double high, QString unit, QString hint,
             Json initial);
Field integer(std::string key, QString label, int low, int high, QString hint, Json initial);
Field flag(std::string key, QString label, QString hint);
Field choice(std::string key, QString label, std::vector<Option> options, QString hint);
Field reference(std::string key, QString label, Source source, QString hint);
Field references(std::string key, QString label, Source source, std::size_t count, QString hint);
Field position(std::string key, QString label, QString hint);
Field numbers(std::string key, QString label, std::size_t count, double low, double high, QString unit,
              QString hint, Json initial);
Field list(std::string key, QString label, ListSpec spec, QString hint);
Field optional(Field field);

}  // namespace sagara::ui::editor
