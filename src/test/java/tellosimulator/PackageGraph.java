package tellosimulator;

import com.tngtech.archunit.core.domain.JavaClass;
import com.tngtech.archunit.core.domain.JavaClasses;
import java.util.Map;
import java.util.Set;
import java.util.TreeMap;
import java.util.TreeSet;
import java.util.function.Function;
import java.util.stream.Collectors;

/**
 * The dependencies between groups of classes, without cycles. Immutable.
 *
 * @param edges each group, and the groups that it uses
 */
record PackageGraph(Map<String, Set<String>> edges) {

  /**
   * Creates the graph of compiled classes.
   *
   * @param group returns the group of a class; empty for classes that are left out
   */
  static PackageGraph of(JavaClasses classes, Function<JavaClass, String> group) {
    Map<String, Set<String>> edges = new TreeMap<>();
    for (JavaClass type : classes) {
      String from = group.apply(type);
      if (from.isEmpty()) {
        continue;
      }
      Set<String> used = edges.computeIfAbsent(from, name -> new TreeSet<>());
      type.getDirectDependenciesFromSelf().stream()
          .map(dependency -> group.apply(dependency.getTargetClass().getBaseComponentType()))
          .filter(to -> !to.isEmpty() && !to.equals(from))
          .forEach(used::add);
    }
    return new PackageGraph(edges);
  }

  /** Returns the transitive reduction: this graph without edges that follow from others. */
  PackageGraph reduced() {
    Map<String, Set<String>> kept = new TreeMap<>();
    edges.forEach(
        (from, used) ->
            kept.put(
                from,
                used.stream()
                    .filter(
                        to ->
                            used.stream().noneMatch(other -> !other.equals(to) && leads(other, to)))
                    .collect(Collectors.toCollection(TreeSet::new))));
    return new PackageGraph(kept);
  }

  private boolean leads(String from, String to) {
    Set<String> used = edges.getOrDefault(from, Set.of());
    return used.contains(to) || used.stream().anyMatch(between -> leads(between, to));
  }

  /** Returns the graph as a Mermaid flowchart, whose arrows point to the used group. */
  String mermaid() {
    StringBuilder chart = new StringBuilder("```mermaid\nflowchart TD\n");
    edges.forEach(
        (from, used) -> {
          if (used.isEmpty()) {
            chart.append("  ").append(from).append('\n');
          }
          used.forEach(
              to -> chart.append("  ").append(from).append(" --> ").append(to).append('\n'));
        });
    return chart.append("```\n").toString();
  }
}
