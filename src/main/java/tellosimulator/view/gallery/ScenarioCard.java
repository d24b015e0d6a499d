package tellosimulator.view.gallery;

import java.util.Locale;
import javafx.animation.PauseTransition;
import javafx.css.PseudoClass;
import javafx.geometry.Orientation;
import javafx.scene.AccessibleAction;
import javafx.scene.AccessibleRole;
import javafx.scene.Node;
import javafx.scene.control.Label;
import javafx.scene.image.ImageView;
import javafx.scene.input.KeyCode;
import javafx.scene.input.KeyEvent;
import javafx.scene.input.MouseButton;
import javafx.scene.input.MouseEvent;
import javafx.scene.layout.HBox;
import javafx.scene.layout.Region;
import javafx.scene.layout.StackPane;
import javafx.scene.layout.VBox;
import javafx.util.Duration;
import org.kordamp.ikonli.feather.Feather;
import org.kordamp.ikonli.javafx.FontIcon;
import tellosimulator.scenario.Description;
import tellosimulator.scenario.Difficulty;
import tellosimulator.view.fx.Nodes;
import tellosimulator.view.text.Language;
import tellosimulator.view.text.Messages;

/**
 * A card that shows the picture, name, difficulty and lesson of a scenario. A click, Enter or Space
 * chooses the scenario. Confined to the JavaFX thread.
 */
final class ScenarioCard extends VBox {

  private static final PseudoClass FILLED = PseudoClass.getPseudoClass("filled");
  private static final PseudoClass CHOSEN = PseudoClass.getPseudoClass("chosen");

  /** The time for which the card is highlighted before its scenario is opened. */
  private static final Duration A_FRAME_OR_TWO = Duration.millis(50);

  private final Language language;
  private final Messages messages;
  private final Description description;
  private final Runnable chosen;
  private final ImageView picture = new ImageView();
  private final Label name = Nodes.styled(new Label(), "name");
  private final Label level = Nodes.styled(new Label(), "level");
  private final HBox difficulty = Nodes.styled(new HBox(), "difficulty");
  private final Label teaches = Nodes.styled(new Label(), "teaches");

  /**
   * @param chosen called when the card is chosen
   */
  ScenarioCard(Language language, Description description, Runnable chosen) {
    this.language = language;
    this.description = description;
    this.chosen = chosen;
    messages = language.messages(ScenarioCard.class);
    getStyleClass().add("scenario-card");
    setFocusTraversable(true);
    setAccessibleRole(AccessibleRole.BUTTON);
    picture.setPreserveRatio(true);
    picture.setSmooth(true);
    Nodes.wrapping(name);
    Nodes.wrapping(teaches);
    layoutParts();
    setupEventHandlers();
    setupBindings();
  }

  /** Returns the node that shows the picture. */
  ImageView picture() {
    return picture;
  }

  /** Sets whether all goals of the scenario have been reached before. */
  void setSolved(boolean solved) {
    name.setGraphic(solved ? new FontIcon(Feather.CHECK_CIRCLE) : null);
    name.setAccessibleHelp(solved ? messages.now("solved") : null);
  }

  private void layoutParts() {
    for (Difficulty each : Difficulty.values()) {
      Region dot = Nodes.styled(new Region(), "dot");
      boolean filled =
          description.difficulty().filter(said -> each.compareTo(said) <= 0).isPresent();
      dot.pseudoClassStateChanged(FILLED, filled);
      difficulty.getChildren().add(dot);
    }
    difficulty.getChildren().add(level);
    difficulty.setVisible(description.difficulty().isPresent());
    getChildren().addAll(new Frame(picture), name, difficulty, teaches);
  }

  private void setupEventHandlers() {
    addEventHandler(
        MouseEvent.MOUSE_CLICKED,
        click -> {
          if (click.getButton() == MouseButton.PRIMARY) {
            choose();
          }
        });
    addEventHandler(
        KeyEvent.KEY_PRESSED,
        key -> {
          if (key.getCode() == KeyCode.ENTER || key.getCode() == KeyCode.SPACE) {
            key.consume();
            choose();
          }
        });
  }

  /**
   * Chooses the scenario. Highlights the card first, because opening the scenario takes a while.
   */
  private void choose() {
    pseudoClassStateChanged(CHOSEN, true);
    PauseTransition shown = new PauseTransition(A_FRAME_OR_TWO);
    shown.setOnFinished(
        over -> {
          pseudoClassStateChanged(CHOSEN, false);
          chosen.run();
        });
    shown.play();
  }

  private void setupBindings() {
    name.textProperty().bind(language.localeProperty().map(description.name()::in));
    level.textProperty().bind(language.localeProperty().map(locale -> level()));
    teaches.textProperty().bind(language.localeProperty().map(this::lesson));
    accessibleTextProperty()
        .bind(
            messages.text(
                "card", name.textProperty(), level.textProperty(), teaches.textProperty()));
  }

  private String level() {
    return description
        .difficulty()
        .map(each -> messages.now(each.name().toLowerCase(Locale.ROOT)))
        .orElse("");
  }

  private String lesson(Locale locale) {
    return messages.now("learn", description.teaches().in(locale));
  }

  @Override
  public void executeAccessibleAction(AccessibleAction action, Object... parameters) {
    if (action == AccessibleAction.FIRE) {
      choose();
    } else {
      super.executeAccessibleAction(action, parameters);
    }
  }

  /** The frame of the picture. It is as wide as the card, even if the picture is missing. */
  private static final class Frame extends StackPane {

    private final ImageView shown;

    Frame(ImageView shown) {
      super((Node) shown);
      this.shown = shown;
      getStyleClass().add("picture");
      setMinSize(0, 0);
      shown.setManaged(false);
    }

    @Override
    protected double computePrefWidth(double height) {
      return RoomCamera.WIDTH / 4.0;
    }

    @Override
    protected double computePrefHeight(double width) {
      return Math.rint((width < 0 ? prefWidth(-1) : width) * RoomCamera.HEIGHT / RoomCamera.WIDTH);
    }

    @Override
    public Orientation getContentBias() {
      return Orientation.HORIZONTAL;
    }

    @Override
    protected void layoutChildren() {
      shown.setFitWidth(getWidth());
      shown.relocate(0, 0);
    }
  }
}
