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
import tellosimulator.view.fx.Nodes;
import tellosimulator.view.text.Language;
import tellosimulator.view.text.Messages;
import tellosimulator.view.world.Simulator3DScene;

/**
 * Creates the buttons of the bars at the top of windows. The id of a button is the prefix of the
 * keys of its texts: a tooltip and usually a label. {@link LabeledToolBar} shows the label if there
 * is space. Confined to the JavaFX thread.
 */
public final class BarButtons {

  private final Messages messages;

  /** Creates a factory for buttons in the given language. */
  public BarButtons(Language language) {
    messages = language.messages(BarButtons.class);
  }

  /** Returns the menu of views. Its label is the name of the current view. */
  public MenuButton camera(Simulator3DScene scene) {
    return new CameraMenu(messages, scene);
  }

  /** Returns the button that shows the whole scene. */
  public Button fit(Simulator3DScene scene) {
    return button("view-fit", Feather.BOX, scene::fit);
  }

  /** Returns the button that keeps the drone in the centre of the view. */
  public ToggleButton follow(Simulator3DScene scene) {
    return toggle("view-follow", Feather.CROSSHAIR, scene.camera().followingProperty());
  }

  /** Returns the button that shows the picture of the drone's camera in the corner of the scene. */
  public ToggleButton inset(Simulator3DScene scene) {
    return toggle("show-inset", Feather.IMAGE, scene.insetVisibleProperty());
  }

  /** Returns the button that shows the flown path. */
  public ToggleButton trail(Simulator3DScene scene) {
    return toggle("show-trail", Feather.ACTIVITY, scene.trailVisibleProperty());
  }

  /**
   * Returns the button that shows the line to the next goal.
   *
   * @param asked whether there are goals; otherwise the button is hidden
   */
  public ToggleButton goalLine(Simulator3DScene scene, ObservableValue<Boolean> asked) {
    ToggleButton button = toggle("show-goal-line", Feather.TARGET, scene.goalLineVisibleProperty());
    Nodes.showIf(button, asked);
    return button;
  }

  /** Returns the button that switches between the light and the dark theme. */
  public Button theme(Property<Theme> theme) {
    FontIcon icon = new FontIcon(Feather.MOON);
    theme.subscribe(now -> icon.setIconCode(now == Theme.LIGHT ? Feather.MOON : Feather.SUN));
    Button button = Nodes.styled(new Button("", icon), Styles.BUTTON_ICON, Styles.FLAT);
    return prepared(button, "theme", () -> theme.setValue(theme.getValue().other()));
  }

  /** Returns the button that switches to full screen. */
  public ToggleButton fullScreen(Property<Boolean> state) {
    return part("full-screen", Feather.MAXIMIZE, state);
  }

  /** Returns a button that shows a part of the window; it never has a label beside its icon. */
  ToggleButton part(String id, Ikon icon, Property<Boolean> state) {
    ToggleButton button =
        Nodes.styled(new ToggleButton("", new FontIcon(icon)), Styles.BUTTON_ICON, Styles.FLAT);
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
    Nodes.named(button, id, Styles.SMALL);
    Nodes.described(button, messages.text(id + "-tip"));
    button.setContentDisplay(ContentDisplay.GRAPHIC_ONLY);
    button.setOnAction(event -> action.run());
    return button;
  }
}
