package tellosimulator.view.layout;

import atlantafx.base.theme.Styles;
import javafx.beans.property.Property;
import javafx.beans.value.ObservableValue;
import javafx.scene.control.Button;
import javafx.scene.control.ButtonBase;
import javafx.scene.control.ContentDisplay;
import javafx.scene.control.MenuButton;
import javafx.scene.control.ToggleButton;
import org.kordamp.ikonli.Ikon;
import org.kordamp.ikonli.feather.Feather;
import org.kordamp.ikonli.javafx.FontIcon;
import tellosimulator.view.fx.Tooltips;
import tellosimulator.view.text.Language;
import tellosimulator.view.text.Messages;
import tellosimulator.view.world.Simulator3DScene;

/**
 * Makes the buttons of the bars at the top of windows. The id of a button is the key of its texts,
 * a hint and mostly a word, for which {@link LabeledToolBar} has room or not. For the JavaFX
 * thread.
 */
public final class BarButtons {

  private final Messages messages;

  /** Buttons that speak a language. */
  public BarButtons(Language language) {
    messages = language.messages(BarButtons.class);
  }

  /** From where one looks; it says which view it is. */
  public MenuButton camera(Simulator3DScene scene) {
    return new CameraMenu(messages, scene);
  }

  /** Shows the whole scene. */
  public Button fit(Simulator3DScene scene) {
    return button("view-fit", Feather.BOX, scene::fit);
  }

  /** Keeps the drone in the middle. */
  public ToggleButton follow(Simulator3DScene scene) {
    return toggle("view-follow", Feather.CROSSHAIR, scene.camera().followingProperty());
  }

  /** Shows the picture of the drone's camera in the corner. */
  public ToggleButton inset(Simulator3DScene scene) {
    return toggle("show-inset", Feather.IMAGE, scene.insetVisibleProperty());
  }

  /** Shows the flown path. */
  public ToggleButton trail(Simulator3DScene scene) {
    return toggle("show-trail", Feather.ACTIVITY, scene.trailVisibleProperty());
  }

  /**
   * Shows the line to the next goal.
   *
   * @param asked whether there are goals; the button is there only then
   */
  public ToggleButton goalLine(Simulator3DScene scene, ObservableValue<Boolean> asked) {
    ToggleButton button = toggle("show-goal-line", Feather.TARGET, scene.goalLineVisibleProperty());
    button.visibleProperty().bind(asked);
    button.managedProperty().bind(asked);
    return button;
  }

  /** Changes between light and dark. */
  public Button theme(Property<Theme> theme) {
    FontIcon icon = new FontIcon(Feather.MOON);
    theme.subscribe(now -> icon.setIconCode(now == Theme.LIGHT ? Feather.MOON : Feather.SUN));
    Button button = new Button("", icon);
    button.getStyleClass().addAll(Styles.BUTTON_ICON, Styles.FLAT);
    return prepared(button, "theme", () -> theme.setValue(theme.getValue().other()));
  }

  /** Fills the screen. */
  public ToggleButton fullScreen(Property<Boolean> state) {
    return part("full-screen", Feather.MAXIMIZE, state);
  }

  /** Shows a part of the window; it never has a word beside its icon. */
  ToggleButton part(String id, Ikon icon, Property<Boolean> state) {
    ToggleButton button = new ToggleButton("", new FontIcon(icon));
    button.getStyleClass().addAll(Styles.BUTTON_ICON, Styles.FLAT);
    button.selectedProperty().bindBidirectional(state);
    return prepared(button, id, () -> {});
  }

  Button button(String id, Ikon icon, Runnable action) {
    Button button = new Button("", new FontIcon(icon));
    button.textProperty().bind(messages.text(id + "-word"));
    button.getStyleClass().addAll(Styles.BUTTON_ICON, Styles.FLAT);
    return prepared(button, id, action);
  }

  ToggleButton toggle(String id, Ikon icon, Property<Boolean> state) {
    ToggleButton button = part(id, icon, state);
    button.textProperty().bind(messages.text(id + "-word"));
    return button;
  }

  private <B extends ButtonBase> B prepared(B button, String id, Runnable action) {
    button.setId(id);
    button.getStyleClass().add(Styles.SMALL);
    Tooltips.install(button, messages.text(id + "-tip"));
    button.accessibleTextProperty().bind(messages.text(id + "-tip"));
    button.setContentDisplay(ContentDisplay.GRAPHIC_ONLY);
    button.setOnAction(event -> action.run());
    return button;
  }
}
