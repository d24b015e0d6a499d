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
import tellosimulator.view.fx.Nodes;

/**
 * A collapsible section of a panel. A click on its heading folds or unfolds the card. Until the
 * user has made this choice, the card is folded while it is not useful, and the panel may fold it
 * if there is not enough space for all cards. Confined to the JavaFX thread.
 */
class Card extends VBox {

  /** The state that the user has chosen, if any. */
  enum Folding {
    /** The user has not chosen, so the panel decides. */
    AUTOMATIC,
    OPEN,
    FOLDED
  }

  private final String name;
  private final ObjectProperty<Folding> folding =
      new SimpleObjectProperty<>(this, "folding", Folding.AUTOMATIC);
  private final ToggleButton head = new ToggleButton();
  private final HBox top = new HBox(head);
  private final VBox content = Nodes.styled(new VBox(), "card-content");
  private final BooleanProperty useful = new SimpleBooleanProperty(this, "useful", true);
  private boolean room = true;

  /**
   * @param name the name in settings; the heading's id is {@code card-} followed by the name
   */
  Card(String name, ObservableValue<String> title) {
    this.name = name;
    getStyleClass().addAll("panel-section", name + "-panel");
    Nodes.named(head, "card-" + name, "card-head");
    head.textProperty().bind(title);
    top.setAlignment(Pos.CENTER_LEFT);
    VBox.setVgrow(content, Priority.ALWAYS);
    getChildren().addAll(top, content);
    head.setOnAction(pressed -> folding.set(head.isSelected() ? Folding.OPEN : Folding.FOLDED));
    folding.subscribe(this::show);
    useful.subscribe(this::show);
  }

  /** Lays out the nodes that can be folded. */
  final void layoutCard(Node... nodes) {
    content.getChildren().addAll(nodes);
  }

  /** Lays out the nodes to the right of the heading. They always stay visible. */
  final void layoutHead(Node... nodes) {
    top.getChildren().add(new Spacer());
    top.getChildren().addAll(List.of(nodes));
  }

  /** Returns the name used in settings. */
  final String name() {
    return name;
  }

  /** The user's choice, which is saved in the settings. */
  final ObjectProperty<Folding> foldingProperty() {
    return folding;
  }

  final boolean isOpen() {
    return content.isVisible();
  }

  final ReadOnlyBooleanProperty openProperty() {
    return content.visibleProperty();
  }

  /**
   * Sets whether there is space for the card. If there is none, the card opens only at the user's
   * request.
   */
  final void setRoom(boolean newRoom) {
    room = newRoom;
    show();
  }

  /** Sets whether the card is useful now. If it is not, it opens only at the user's request. */
  final void setUseful(boolean newUseful) {
    useful.set(newUseful);
  }

  final ReadOnlyBooleanProperty usefulProperty() {
    return useful;
  }

  private void show() {
    boolean open =
        folding.get() == Folding.AUTOMATIC ? room && useful.get() : folding.get() == Folding.OPEN;
    Nodes.setShown(content, open);
    head.setSelected(open);
    head.setGraphic(new FontIcon(open ? Feather.CHEVRON_DOWN : Feather.CHEVRON_RIGHT));
  }
}
