package tellosimulator.benchmark;

/**
 * A line of the benchmark table.
 *
 * @param what is measured
 * @param target what shall be reached
 * @param measured what was reached
 * @param reached whether that is enough
 */
record Row(String what, String target, String measured, boolean reached) {

  String markdown() {
    return "| %s | %s | %s | %s |".formatted(what, target, measured, reached ? "yes" : "**no**");
  }
}
