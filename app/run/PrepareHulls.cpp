#include "app/run/PrepareHulls.h"

#include <sched.h>

#include "app/run/DatabaseTables.h"
#include "core/vessel/Vessel.h"
#include "db/DocumentRepository.h"

namespace sagara::run {
namespace {

std::vector<std::string> vesselTexts(const Store& store) {
    std::vector<std::string> texts;
    if (!store.database()) return texts;
    try {
        for (const auto& entry : db::DocumentRepository(*store.database(), db::DocumentTable::Vessel).inUse())
            if (auto text = store.find(core::DocumentKind::Vessel, entry.key)) texts.push_back(*text);
    } catch (const db::DbError&) {
        // Then the tables are made when they are needed.
    }
    return texts;
}

}  // namespace

PrepareHulls::PrepareHulls(const Store& store)
    : m_worker([texts = vesselTexts(store), file = store.folder().database()](const std::stop_token& stop) {
          const sched_param none{};
          (void)sched_setscheduler(0, SCHED_IDLE, &none);
          DatabaseTables kept(file);
          for (const std::string& text : texts) {
              if (stop.stop_requested()) return;
              const auto vessel = core::loadVessel("vessel", text);
              if (vessel) (void)core::tablesFor(core::hullFormOf(vessel->hull), {}, &kept);
          }
      }) {}

}  // namespace sagara::run
