// expect: image_part: the first table is an image_table of a command, with a row counter for the outputs
#include <jauscat/app.hpp>
#include <jauscat/app/own_table.hpp>
#include <jauscat/schema/translation/wrench_effort_image.hpp>

namespace translation = jauscat::translation;

void use(jauscat::bridge& bridge, const jauscat::slave& slave) {
    using reports = translation::report_wrench_effort_table; // no counter: the slave's application sets it
    bridge.serve({.component = 33}, slave, jauscat::process_image<reports, reports>());
}
