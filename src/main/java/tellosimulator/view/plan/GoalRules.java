package tellosimulator.view.plan;

import java.util.OptionalDouble;
import java.util.function.UnaryOperator;
import javafx.scene.control.CheckBox;
import javafx.scene.control.Label;
import javafx.scene.layout.HBox;
import javafx.scene.layout.VBox;
import tellosimulator.goal.Challenge;
import tellosimulator.scenario.Quantity;
import tellosimulator.view.controls.NumberField;
import tellosimulator.view.controls.NumberRange;
import tellosimulator.view.text.Language;
import tellosimulator.view.text.Messages;

/**
 * The part of the property panel that edits the rules for all goals. Confined to the JavaFX thread.
 */
final class GoalRules extends VBox {

  /** The range of the time limit [s]; 0 stands for no limit. */
  private static final NumberRange LIMIT = new NumberRange(0, Quantity.TIME_LIMIT.most(), 10);

  private final PlanEditor editor;
  private final CheckBox inOrder;
  private final CheckBox untouched;
  private final NumberField limit;

  GoalRules(PlanEditor editor, Language language) {
    this.editor = editor;
    Messages messages = language.messages(GoalRules.class);
    inOrder = rule("goals-in-order", messages);
    untouched = rule("goals-untouched", messages);
    limit = new NumberField("goals-time-limit", LIMIT, language);
    setId("goal-rules-of-plan");
    getStyleClass().add("goal-rules");
    layoutParts(messages);
    setupEventHandlers();
  }

  private static CheckBox rule(String id, Messages messages) {
    CheckBox rule = new CheckBox();
    rule.setId(id);
    rule.textProperty().bind(messages.text(id));
    rule.setWrapText(true);
    return rule;
  }

  private void layoutParts(Messages messages) {
    Label label = messages.label("goals-time-limit");
    label.setLabelFor(limit);
    limit.accessibleTextProperty().bind(label.textProperty());
    HBox row = new HBox(label, limit);
    row.getStyleClass().add("row");
    getChildren()
        .addAll(messages.label("goals-all", "title"), inOrder, untouched, row, limit.error());
  }

  private void setupEventHandlers() {
    inOrder.setOnAction(pressed -> change(rules -> rules.withInOrder(inOrder.isSelected())));
    untouched.setOnAction(pressed -> change(rules -> rules.withUntouched(untouched.isSelected())));
    limit.onNumber(seconds -> change(rules -> rules.withTimeLimit(limit(seconds))));
  }

  private static OptionalDouble limit(double seconds) {
    return seconds > 0
        ? OptionalDouble.of(Math.max(Quantity.TIME_LIMIT.least(), seconds))
        : OptionalDouble.empty();
  }

  private void change(UnaryOperator<Challenge> change) {
    editor.carryOut(editor.plan().withChallenge(change.apply(editor.plan().challenge())));
  }

  /** Shows the rules of a challenge. */
  void show(Challenge rules) {
    inOrder.setSelected(rules.inOrder());
    untouched.setSelected(rules.untouched());
    limit.show(rules.timeLimit().orElse(0));
  }
}
