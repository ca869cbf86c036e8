#include "app/tools/HydrostaticsTool.h"

#include "app/run/Console.h"
#include "app/run/RunOptions.h"
#include "app/tools/Table.h"
#include "core/seakeeping/Hydrostatics.h"

namespace sagara::tools {

int runHydrostatics(const run::Store& store, const HydrostaticsOptions& o) {
    const auto form = openHull(store, o.hull);
    if (!form) return run::tell(form.error()), run::kBadRequest;
    return writeResult(o.csv, core::hydrostaticsReport(*form));
}

}  // namespace sagara::tools
