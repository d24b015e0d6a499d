package tellosimulator.view.layout;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.stream.DoubleStream;
import javafx.beans.value.ObservableValue;
import tellosimulator.fault.LinkPreset;
import tellosimulator.scenario.Gallery;
import tellosimulator.scenario.Scenario;
import tellosimulator.sim.Control;
import tellosimulator.time.TimeFactor;
import tellosimulator.translation.PhraseCatalog;
import tellosimulator.view.controls.NetworkControls;
import tellosimulator.view.layout.WindowCommand.Group;
import tellosimulator.view.layout.WindowState.Flag;
import tellosimulator.view.model.FxDroneModel;
import tellosimulator.view.model.ViewContext;
import tellosimulator.view.text.Messages;

/**
 * A table of all commands of the window: the actions of its keys, and the commands that choose or
 * set a value. The menu shows them by group, and the palette searches them. Confined to the JavaFX
 * thread.
 */
public final class WindowCommands {

  /** Wind speeds that are offered [m/s]; others can be typed. */
  private static final int[] WINDS = {1, 2, 3, 5};

  /** Time factors that are offered; others can be typed. */
  private static final double[] FACTORS = {0.25, 0.5, 1, 2, 5, 10};

  private final ViewContext context;
  private final WindowState state;
  private final Messages messages;
  private final ValueCommands values;
  private final List<WindowCommand> listed = new ArrayList<>();
  private List<WindowCommand> scenarios = List.of();

  /**
   * @param keys the keys of the window with their actions
   */
  public WindowCommands(ViewContext context, WindowState state, KeyBindings keys) {
    this.context = context;
    this.state = state;
    messages = context.language().messages(WindowCommands.class);
    values = new ValueCommands(context, messages);
    keys.actions()
        .forEach(
            (key, action) ->
                listed.add(WindowCommand.of(key, messages.text(key.textKey()), action)));
    context
        .scenario()
        .course()
        .ifPresent(
            seed ->
                listed.add(
                    WindowCommand.of(
                        Group.SCENARIO,
                        messages.text("next-course", Long.toString(seed)),
                        "seed",
                        context.scenario().actions()::openNextCourse)));
    addDrone();
    addTime();
    addWind();
    addFaults();
    addAppearance();
  }

  /**
   * Returns the commands of the menu. The gallery's scenarios are not included, because the gallery
   * itself lists them.
   */
  List<WindowCommand> listed() {
    return listed;
  }

  /**
   * Returns the commands that match a text, from the best match to the worst; all commands if the
   * text is empty.
   *
   * @param typed words in any order, or a word and a value such as {@code wind 2}
   */
  List<WindowCommand> find(String typed) {
    String[] words = typed.toLowerCase(Locale.ROOT).strip().split("\\s+");
    List<WindowCommand> found = new ArrayList<>(listed);
    found.addAll(scenarios());
    if (words[0].isEmpty()) {
      return found;
    }
    found.removeIf(command -> rank(command, words).isEmpty());
    found.sort(Comparator.comparing(command -> rank(command, words).get()));
    values.read(typed.strip()).ifPresent(command -> putFirst(command, found));
    return found;
  }

  /** Puts a command first in the list, and removes its other occurrence if there is one. */
  private static void putFirst(WindowCommand command, List<WindowCommand> found) {
    String title = command.title().getValue();
    found.removeIf(other -> other.title().getValue().equals(title));
    found.add(0, command);
  }

  private Optional<Integer> rank(WindowCommand command, String... words) {
    return command.rank(messages.now(command.group().textKey()), words);
  }

  /**
   * Returns the commands for the gallery's scenarios. The scenarios are read at the first search.
   */
  private List<WindowCommand> scenarios() {
    if (scenarios.isEmpty()) {
      scenarios =
          Gallery.NAMES.stream()
              .map(
                  name ->
                      WindowCommand.of(
                          Group.SCENARIO,
                          opening(Gallery.find(name).get()),
                          name,
                          () -> context.scenario().actions().openKnown(name)))
              .toList();
    }
    return scenarios;
  }

  private ObservableValue<String> opening(Scenario scenario) {
    return context
        .language()
        .localeProperty()
        .flatMap(locale -> messages.text("command-open", scenario.description().name().in(locale)));
  }

  private void addDrone() {
    add(Group.DRONE, "command-power", () -> power(drone()));
    add(Group.DRONE, "command-reset", () -> carryOut(new Control.Reset(drone().number())));
    add(
        Group.DRONE,
        "command-charge",
        () -> carryOut(new Control.SetBattery(drone().number(), 100)));
  }

  private void addTime() {
    DoubleStream.of(FACTORS)
        .forEach(factor -> listed.add(values.timeFactor(new TimeFactor(factor))));
    listed.add(values.timeFactor(TimeFactor.MAX));
  }

  private void addWind() {
    listed.add(values.wind(0));
    for (int speed : WINDS) {
      listed.add(values.wind(speed));
    }
  }

  private void addFaults() {
    Messages panels = context.language().messages(NetworkControls.class);
    for (LinkPreset link : LinkPreset.values()) {
      ObservableValue<String> title = panels.text("faults.link." + link.option());
      listed.add(
          WindowCommand.of(
              Group.FAULTS,
              title,
              "link " + link.option(),
              () -> carryOut(new Control.SetLink(link))));
    }
    add(Group.FAULTS, "command-no-faults", () -> carryOut(new Control.ClearFaults()));
  }

  private void addAppearance() {
    add(Group.RECORDING, "record-flights", () -> state.toggle(Flag.RECORDED_FLIGHTS));
    add(Group.RECORDING, "grade-flight", context.scenario().actions()::gradeFlight);
    for (Theme theme : Theme.values()) {
      String name = theme.name().toLowerCase(Locale.ROOT);
      add(Group.THEME, "theme-" + name, name, () -> state.themeProperty().set(theme));
    }
    for (Locale language : PhraseCatalog.OFFERED) {
      String name = language.getLanguage();
      String aliases = language.getDisplayLanguage(Locale.ENGLISH);
      add(
          Group.LANGUAGE,
          "language-" + name,
          aliases,
          () -> context.language().localeProperty().set(language));
    }
  }

  private void add(Group group, String key, Runnable action) {
    add(group, key, "", action);
  }

  private void add(Group group, String key, String aliases, Runnable action) {
    listed.add(WindowCommand.of(group, messages.text(key), aliases, action));
  }

  private void power(FxDroneModel drone) {
    context.actions().switchPower(drone.number(), !drone.onProperty().get());
  }

  private FxDroneModel drone() {
    return context.simulation().selected();
  }

  private void carryOut(Control control) {
    context.actions().carryOut(control);
  }
}
