package tellosimulator.view.controls;

import javafx.scene.control.Control;
import javafx.scene.control.Label;
import javafx.scene.layout.HBox;
import tellosimulator.view.fx.Nodes;
import tellosimulator.view.fx.Tooltips;
import tellosimulator.view.text.Messages;

/** A row of a form: a label with the name and unit of a control, and the control itself. */
final class FormRow extends HBox {

  /**
   * @param key the key of the name; the key of the tooltip has the suffix {@code .hint}
   */
  FormRow(Messages messages, String key, Control control) {
    Label name = Nodes.growing(messages.label(key, "caption"));
    name.setLabelFor(control);
    control.accessibleTextProperty().bind(name.textProperty());
    Nodes.styled(this, "row");
    Tooltips.install(this, messages.text(key + ".hint"));
    getChildren().addAll(name, control);
  }
}
