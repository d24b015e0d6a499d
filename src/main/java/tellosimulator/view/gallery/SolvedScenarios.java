package tellosimulator.view.gallery;

import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.TreeSet;
import javafx.beans.property.ObjectProperty;
import javafx.beans.property.SimpleObjectProperty;
import tellosimulator.scenario.Gallery;
import tellosimulator.view.settings.SettingCodec;
import tellosimulator.view.settings.Settings;

/**
 * The gallery's scenarios whose goals have all been reached at least once. Confined to the JavaFX
 * thread.
 */
public final class SolvedScenarios {

  private static final String SEPARATOR = ",";

  private final ObjectProperty<Set<String>> names =
      new SimpleObjectProperty<>(this, "names", Set.of());

  /** Restores the set from the settings, and saves its changes. */
  public static SolvedScenarios remembered(Settings settings) {
    SolvedScenarios solved = new SolvedScenarios();
    settings.bind("solved-scenarios", solved.names, codec());
    return solved;
  }

  /** Adds a scenario whose goals have all been reached. */
  public void add(String name) {
    if (!contains(name)) {
      Set<String> more = new TreeSet<>(names.get());
      more.add(name);
      names.set(Set.copyOf(more));
    }
  }

  /** Returns whether all goals of a scenario have been reached before. */
  boolean contains(String name) {
    return names.get().contains(name);
  }

  private static SettingCodec<Set<String>> codec() {
    return new SettingCodec<>(
        "names of scenarios that come with the program, with commas between them",
        text ->
            Optional.of(Set.copyOf(new TreeSet<>(List.of(text.split(SEPARATOR, -1)))))
                .filter(Gallery.NAMES::containsAll),
        solved -> String.join(SEPARATOR, new TreeSet<>(solved)));
  }
}
