#include <jauscat/app.hpp>
#include <jauscat/app/own_table.hpp>
#include <jauscat/schema/translation/wrench_effort_image.hpp>

namespace translation = jauscat::translation;

#ifdef GOOD
// expect: no error
void use(jauscat::bridge& bridge, const jauscat::slave& slave) {
    using commands = translation::set_wrench_effort_table;
    using reports = translation::report_wrench_effort_table;
    bridge.serve({.component = 33}, slave, jauscat::process_image<commands, reports>());
    bridge.serve({.component = 34}, slave,
                 jauscat::process_image<commands, reports>({.propulsive_linear_effort_x = 0}));
}
#endif

#ifdef OF_NO_REPORT
// expect: image_part: the second table is an image_table of a report that answers a query, for the inputs
void use(jauscat::bridge& bridge, const jauscat::slave& slave) {
    using commands = translation::set_wrench_effort_table;
    bridge.serve({.component = 33}, slave, jauscat::process_image<commands, commands>());
}
#endif

#ifdef WITHOUT_COUNTER
// expect: image_part: the first table is an image_table of a command, with a row counter for the outputs
void use(jauscat::bridge& bridge, const jauscat::slave& slave) {
    using reports = translation::report_wrench_effort_table; // no counter: the slave's application sets it
    bridge.serve({.component = 33}, slave, jauscat::process_image<reports, reports>());
}
#endif
