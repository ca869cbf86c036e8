#include "Commands.h"
#include "app/tools/Validate.h"

namespace sagara::sim {

void addValidate(Commands& commands) {
    auto o = std::make_shared<tools::ValidateOptions>();
    CLI::App* validate = commands.add("validate", "run the ships against published results, and report",
                                      [o](run::Store& store) { return tools::runValidate(store, *o); });
    validate->add_option("--out", o->out, "folder for validation.pdf (this one)");
    validate->add_option("--case", o->cases, "only these, by the names of their files in assets/validation");
}

}  // namespace sagara::sim
