#include "core/vessel/Provenance.h"

namespace sagara::core {

Provenance readProvenance(config::Reader& in) {
    Provenance p;
    p.source = in.text("source");
    p.quality = in.choice<Quality>("quality", {{"measured", Quality::Measured},
                                               {"fitted", Quality::Fitted},
                                               {"published", Quality::Published},
                                               {"estimated", Quality::Estimated},
                                               {"tuned", Quality::Tuned}});
    return p;
}

const char* qualityName(Quality quality) {
    switch (quality) {
        case Quality::Measured:
            return "measured";
        case Quality::Fitted:
            return "fitted";
        case Quality::Published:
            return "published";
        case Quality::Estimated:
            return "estimated";
        case Quality::Tuned:
            return "tuned";
    }
    return "";
}

}  // namespace sagara::core
