#include "ui/editor/RowsModel.h"

#include "ui/editor/FieldText.h"

namespace sagara::ui::editor {
namespace {

bool isTyped(const Field& field) {
    return field.kind == FieldKind::Text || field.kind == FieldKind::Id || field.kind == FieldKind::Number ||
           field.kind == FieldKind::Integer || field.kind == FieldKind::Position;
}

}  // namespace

RowsModel::RowsModel(EditorContext& context, const ListSpec& spec, std::string path, QObject* parent)
    : QAbstractTableModel(parent), m_context(context), m_spec(spec), m_path(std::move(path)) {
    refresh();
}

void RowsModel::refresh() {
    const int count = static_cast<int>(sizeAt(m_context.draft().document(), m_path));
    if (count > m_count) {
        beginInsertRows({}, m_count, count - 1);
        m_count = count;
        endInsertRows();
    } else if (count < m_count) {
        beginRemoveRows({}, count, m_count - 1);
        m_count = count;
        endRemoveRows();
    }
    if (m_count > 0) Q_EMIT dataChanged(index(0, 0), index(m_count - 1, columnCount() - 1));
}

void RowsModel::showProblems(const std::vector<core::config::Problem>& problems) {
    m_problems.clear();
    for (const auto& p : problems) {
        if (!within(p.path, m_path) || p.path == m_path) continue;
        const int row = static_cast<int>(indexOf(p.path.substr(0, p.path.find(']', m_path.size()) + 1)));
        QString& text = m_problems[row];
        if (!text.isEmpty()) text += u'\n';
        text += QString::fromStdString(p.path.substr(m_path.size()) + " " + p.found);
    }
    if (m_count > 0) Q_EMIT dataChanged(index(0, 0), index(m_count - 1, columnCount() - 1));
}

int RowsModel::rowCount(const QModelIndex& parent) const { return parent.isValid() ? 0 : m_count; }

int RowsModel::columnCount(const QModelIndex& parent) const {
    return parent.isValid() ? 0 : static_cast<int>(m_spec.columns.size());
}

const Json* RowsModel::row(int index) const {
    return m_context.draft().at(join(m_path, static_cast<std::size_t>(index)));
}

QString RowsModel::cell(const Json& row, int column) const {
    if (key(column) == "*") return rowInWords(m_spec, row);
    if (key(column) == m_spec.kindKey) {
        const Variant* variant = m_spec.variantOf(row);
        return variant ? variant->label : QString();
    }
    const Field* field = m_spec.field(key(column));
    return field ? shown(*field, editor::find(row, field->key)) : QString();
}

QVariant RowsModel::data(const QModelIndex& index, int role) const {
    const Json* item = index.isValid() ? row(index.row()) : nullptr;
    if (!item) return {};
    const auto problem = m_problems.find(index.row());
    const bool bad = problem != m_problems.end();
    if (role == Qt::DisplayRole) {
        const QString text = cell(*item, index.column());
        return bad && index.column() == 0 ? QStringLiteral("▲ ") + text : text;
    }
    if (role == Qt::EditRole) return cell(*item, index.column());
    if (role == Qt::ToolTipRole) {
        const Field* field = m_spec.field(key(index.column()));
        return bad ? problem->second : field ? field->hint : cell(*item, index.column());
    }
    return {};
}

QVariant RowsModel::headerData(int section, Qt::Orientation orientation, int role) const {
    if (orientation == Qt::Vertical) return role == Qt::DisplayRole ? QVariant(section + 1) : QVariant();
    const Field* field = m_spec.field(key(section));
    if (role == Qt::ToolTipRole) return field ? QVariant(field->hint) : QVariant();
    if (role != Qt::DisplayRole) return {};
    if (key(section) == "*") return words("In words");
    if (key(section) == m_spec.kindKey) return words("Kind");
    if (!field) return {};
    const bool unitSaid = field->unit.isEmpty() || field->label.contains(u',');
    return unitSaid ? field->label : QStringLiteral("%1, %2").arg(field->label, field->unit);
}

Qt::ItemFlags RowsModel::flags(const QModelIndex& index) const {
    Qt::ItemFlags flags = QAbstractTableModel::flags(index);
    const Field* field = index.isValid() ? m_spec.field(key(index.column())) : nullptr;
    if (field && isTyped(*field)) flags |= Qt::ItemIsEditable;
    return flags;
}

bool RowsModel::setData(const QModelIndex& index, const QVariant& value, int role) {
    const Field* field = index.isValid() ? m_spec.field(key(index.column())) : nullptr;
    if (!field || role != Qt::EditRole) return false;
    const std::string at = join(join(m_path, static_cast<std::size_t>(index.row())), field->key);
    const QString text = value.toString();
    if (text == cell(*row(index.row()), index.column())) return true;
    const QString what = words("change of %1").arg(field->label.toLower());
    if (text.trimmed().isEmpty() && field->optional) {
        m_context.draft().edit(what, [&](Json& document) { erase(document, at); });
        return true;
    }
    auto entry = typed(*field, text);
    if (!entry) {
        m_context.say(words("%1: \"%2\" was not taken; expected %3").arg(field->label, text, accepted(*field)));
        return false;
    }
    m_context.draft().set(at, std::move(*entry), what);
    return true;
}

}  // namespace sagara::ui::editor
