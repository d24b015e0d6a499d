package tellosimulator.view.goal;

import java.util.OptionalDouble;
import javafx.css.PseudoClass;
import javafx.scene.control.Label;
import javafx.scene.layout.HBox;
import javafx.scene.layout.Priority;
import org.kordamp.ikonli.feather.Feather;
import org.kordamp.ikonli.javafx.FontIcon;
import tellosimulator.goal.Goal;
import tellosimulator.view.text.Language;

/** A goal with its tick, and when it was reached. For the JavaFX thread. */
final class GoalRow extends HBox {

  private static final PseudoClass REACHED = PseudoClass.getPseudoClass("reached");
  private static final PseudoClass NEXT = PseudoClass.getPseudoClass("next");

  private final Language language;
  private final FontIcon tick = new FontIcon(Feather.CIRCLE);
  private final Label task = new Label();
  private final Label time = new Label();

  /**
   * @param index of the goal, from 0
   */
  GoalRow(int index, Goal goal, Language language) {
    this.language = language;
    setId("goal-" + (index + 1));
    getStyleClass().add("goal");
    task.textProperty().bind(language.localeProperty().map(locale -> language.say(goal.phrase())));
    task.setWrapText(true);
    task.setMaxWidth(Double.MAX_VALUE);
    task.setMinHeight(USE_PREF_SIZE);
    time.setMinWidth(USE_PREF_SIZE);
    time.getStyleClass().add("time");
    HBox.setHgrow(task, Priority.ALWAYS);
    getChildren().addAll(tick, task, time);
  }

  /**
   * Shows how it stands.
   *
   * @param reached after how many seconds it was reached; empty if it was not
   * @param next whether it can be reached now
   */
  void show(OptionalDouble reached, boolean next) {
    boolean done = reached.isPresent();
    tick.setIconCode(done ? Feather.CHECK_CIRCLE : Feather.CIRCLE);
    time.setText(done ? String.format(language.locale(), "%.1f s", reached.getAsDouble()) : "");
    pseudoClassStateChanged(REACHED, done);
    pseudoClassStateChanged(NEXT, next);
  }
}
