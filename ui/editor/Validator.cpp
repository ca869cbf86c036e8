#include "ui/editor/Validator.h"

#include <QtConcurrent/QtConcurrentRun>

namespace sagara::ui::editor {
namespace {

constexpr int kSoon_ms = 300;

Problems listOf(const core::config::Problems& found) {
    Problems all = found.list();
    const std::vector<std::string> messages = found.messages();
    for (std::size_t i = all.size(); i < messages.size(); ++i) all.push_back({{}, messages[i], {}});
    return all;
}

}  // namespace

core::Result<std::shared_ptr<const core::World>, Problems> worldOf(const std::string& text,
                                                                   const core::DocumentSource& documents,
                                                                   core::WorldUse use) {
    const auto collected = core::collectDocuments({"scenario", text}, documents);
    if (!collected) return listOf(collected.error());
    auto world = core::buildWorld(*collected, 1, use);
    if (!world) return listOf(world.error());
    return std::move(world).value();
}

Validator::Validator(EditorContext& context, QObject* parent) : QObject(parent), m_context(context) {
    m_soon.setSingleShot(true);
    m_soon.setInterval(kSoon_ms);
    connect(&m_soon, &QTimer::timeout, this, &Validator::check);
    connect(&context.draft(), &ScenarioDraft::changed, this, [this] { m_soon.start(); });
    connect(&m_worker, &QFutureWatcherBase::finished, this, [this] {
        m_problems = m_worker.result();
        m_checked = m_checking;
        Q_EMIT checked();
        if (!upToDate() && !m_soon.isActive()) m_soon.start();
    });
}

void Validator::check() {
    if (m_worker.isRunning()) return;  // looks again when it is done
    m_checking = m_context.draft().shared();
    m_worker.setFuture(QtConcurrent::run([draft = m_checking, documents = m_context.documents()] {
        const auto world = worldOf(draft->dump(), *documents, core::WorldUse::Look);
        return world ? Problems() : world.error();
    }));
}

}  // namespace sagara::ui::editor
