package tellosimulator.view.layout;

import java.util.List;
import java.util.Optional;
import javafx.scene.Node;
import javafx.scene.control.ContentDisplay;
import javafx.scene.control.Labeled;
import javafx.scene.control.ToolBar;

/**
 * A bar of buttons that have labels beside their icons if there is space. Either all buttons of a
 * group have labels or none. The most important groups get labels first. Confined to the JavaFX
 * thread.
 */
public class LabeledToolBar extends ToolBar {

  /** The ids of the buttons in each group. The groups are in order of decreasing importance. */
  private static final List<List<String>> GROUPS =
      List.of(
          List.of("scenarios"),
          List.of("settings", "help"),
          List.of("view-fit", "view-follow"),
          List.of("show-inset", "show-trail", "show-goal-line", "show-drones", "show-plan"),
          List.of("scenario-file"));

  /** Space kept free between the buttons at the left and at the right [px]. Decided: by eye. */
  private static final double GAP = 24;

  /** Gap between two items [px], as in the style sheet. */
  private static final double SPACING = 3;

  /** The values on which the space for labels depends. */
  private record Need(double width, List<String> shown) {}

  private Optional<Need> fitted = Optional.empty();

  /** Creates a bar with the given items. */
  public LabeledToolBar(Node... items) {
    super(items);
  }

  @Override
  protected void layoutChildren() {
    Need need = need();
    if (!fitted.equals(Optional.of(need))) { // setting labels requests another layout
      fitted = Optional.of(need);
      fit();
    }
    super.layoutChildren();
  }

  private Need need() {
    List<String> shown =
        getItems().stream()
            .filter(Node::isManaged)
            .map(item -> item instanceof Labeled labeled ? labeled.getText() : "")
            .toList();
    return new Need(getWidth(), shown);
  }

  private void fit() {
    List<List<Labeled>> groups = GROUPS.stream().map(this::found).toList();
    groups.forEach(group -> show(group, ContentDisplay.GRAPHIC_ONLY));
    double room = getWidth() - snappedLeftInset() - snappedRightInset() - GAP - width();
    for (List<Labeled> group : groups) {
      double before = width(group);
      show(group, ContentDisplay.LEFT);
      double more = width(group) - before;
      if (more > room) { // labels of a less important, narrower group would look arbitrary
        show(group, ContentDisplay.GRAPHIC_ONLY);
        return;
      }
      room -= more;
    }
  }

  private static void show(List<Labeled> group, ContentDisplay display) {
    group.forEach(button -> button.setContentDisplay(display));
  }

  private List<Labeled> found(List<String> ids) {
    return ids.stream().flatMap(id -> find(id).stream()).toList();
  }

  private Optional<Labeled> find(String id) {
    return getItems().stream()
        .filter(item -> id.equals(item.getId()) && item.isManaged())
        .map(Labeled.class::cast)
        .findFirst();
  }

  /** Returns the width of all items [px]. */
  private double width() {
    List<Node> shown = getItems().stream().filter(Node::isManaged).toList();
    return width(shown) + SPACING * Math.max(0, shown.size() - 1);
  }

  private static double width(List<? extends Node> items) {
    return items.stream().mapToDouble(item -> item.prefWidth(-1)).sum();
  }
}
