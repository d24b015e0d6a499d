package tellosimulator.view.controls;

import atlantafx.base.controls.Spacer;
import java.util.List;
import javafx.beans.property.BooleanProperty;
import javafx.beans.property.ObjectProperty;
import javafx.beans.property.ReadOnlyBooleanProperty;
import javafx.beans.property.SimpleBooleanProperty;
import javafx.beans.property.SimpleObjectProperty;
import javafx.beans.value.ObservableValue;
import javafx.geometry.Pos;
import javafx.scene.Node;
import javafx.scene.control.ToggleButton;
import javafx.scene.layout.HBox;
import javafx.scene.layout.Priority;
import javafx.scene.layout.VBox;
import org.kordamp.ikonli.feather.Feather;
import org.kordamp.ikonli.javafx.FontIcon;

/**
 * A part of a panel below a heading, which folds it away and back. What nobody has folded or opened
 * is folded while it is of no use, and by its panel where there is no room for everything. For the
 * JavaFX thread.
 */
class Card extends VBox {

  /** Who decides whether it is open. */
  enum Folding {
    /** The panel. */
    AUTOMATIC,
    OPEN,
    FOLDED
  }

  private final String name;
  private final ObjectProperty<Folding> folding =
      new SimpleObjectProperty<>(this, "folding", Folding.AUTOMATIC);
  private final ToggleButton head = new ToggleButton();
  private final HBox top = new HBox(head);
  private final VBox content = new VBox();
  private final BooleanProperty useful = new SimpleBooleanProperty(this, "useful", true);
  private boolean room = true;

  /**
   * @param name in settings; the heading's id is {@code card-} with it
   */
  Card(String name, ObservableValue<String> title) {
    this.name = name;
    getStyleClass().addAll("panel-section", name + "-panel");
    head.setId("card-" + name);
    head.getStyleClass().add("card-head");
    head.textProperty().bind(title);
    content.getStyleClass().add("card-content");
    top.setAlignment(Pos.CENTER_LEFT);
    VBox.setVgrow(content, Priority.ALWAYS);
    getChildren().addAll(top, content);
    head.setOnAction(pressed -> folding.set(head.isSelected() ? Folding.OPEN : Folding.FOLDED));
    folding.subscribe(this::show);
    useful.subscribe(this::show);
  }

  /** Lays out what can be folded away. */
  final void layoutCard(Node... nodes) {
    content.getChildren().addAll(nodes);
  }

  /** Lays out what stays at the right of the heading. */
  final void layoutHead(Node... nodes) {
    top.getChildren().add(new Spacer());
    top.getChildren().addAll(List.of(nodes));
  }

  /** See {@link Card}. */
  final String name() {
    return name;
  }

  /** What a person wants, which is remembered. */
  final ObjectProperty<Folding> foldingProperty() {
    return folding;
  }

  final boolean isOpen() {
    return content.isVisible();
  }

  final ReadOnlyBooleanProperty openProperty() {
    return content.visibleProperty();
  }

  /** Says whether there is room for it, without which it is open only if a person wants it. */
  final void setRoom(boolean newRoom) {
    room = newRoom;
    show();
  }

  /** Says whether it is of use now, without which it is open only if a person wants it. */
  final void setUseful(boolean newUseful) {
    useful.set(newUseful);
  }

  final ReadOnlyBooleanProperty usefulProperty() {
    return useful;
  }

  private void show() {
    boolean open =
        folding.get() == Folding.AUTOMATIC ? room && useful.get() : folding.get() == Folding.OPEN;
    content.setVisible(open);
    content.setManaged(open);
    head.setSelected(open);
    head.setGraphic(new FontIcon(open ? Feather.CHEVRON_DOWN : Feather.CHEVRON_RIGHT));
  }
}
