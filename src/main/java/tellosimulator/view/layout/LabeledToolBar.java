package tellosimulator.view.layout;

import java.util.List;
import java.util.Optional;
import javafx.scene.Node;
import javafx.scene.control.ContentDisplay;
import javafx.scene.control.Labeled;
import javafx.scene.control.ToolBar;

/**
 * A bar of buttons with icons, of which as many as there is room for have words beside their icons;
 * the most important ones first. For the JavaFX thread.
 */
public class LabeledToolBar extends ToolBar {

  /** The ids of the buttons, the most important ones first. */
  private static final List<String> IMPORTANCE =
      List.of(
          "scenarios",
          "help",
          "show-plan",
          "view-fit",
          "view-follow",
          "scenario-file",
          "show-log",
          "settings",
          "show-drones",
          "show-trail",
          "show-goal-line",
          "show-inset",
          "show-network",
          "show-controls");

  /** What stays free between the buttons at the left and at the right [px]. Decided: by eye. */
  private static final double GAP = 24;

  /** Between two items [px]; that of the style sheet. */
  private static final double SPACING = 3;

  /** All on which the room for words depends. */
  private record Need(double width, List<String> shown) {}

  private Optional<Need> fitted = Optional.empty();

  /** A bar of these. */
  public LabeledToolBar(Node... items) {
    super(items);
  }

  @Override
  protected void layoutChildren() {
    Need need = need();
    if (!fitted.equals(Optional.of(need))) { // setting words asks for another layout
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
    List<Labeled> buttons = IMPORTANCE.stream().flatMap(id -> find(id).stream()).toList();
    buttons.forEach(button -> button.setContentDisplay(ContentDisplay.GRAPHIC_ONLY));
    double room = getWidth() - snappedLeftInset() - snappedRightInset() - GAP - width();
    for (Labeled button : buttons) {
      double before = button.prefWidth(-1);
      button.setContentDisplay(ContentDisplay.LEFT);
      double more = button.prefWidth(-1) - before;
      if (more <= room) {
        room -= more;
      } else {
        button.setContentDisplay(ContentDisplay.GRAPHIC_ONLY);
      }
    }
  }

  private Optional<Labeled> find(String id) {
    return getItems().stream()
        .filter(item -> id.equals(item.getId()) && item.isManaged())
        .map(Labeled.class::cast)
        .findFirst();
  }

  /** What all items take [px]. */
  private double width() {
    List<Node> shown = getItems().stream().filter(Node::isManaged).toList();
    return shown.stream().mapToDouble(item -> item.prefWidth(-1)).sum()
        + SPACING * Math.max(0, shown.size() - 1);
  }
}
