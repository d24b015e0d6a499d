package tellosimulator.view.fx;

import javafx.scene.Parent;

/**
 * What all windows have in common over the theme: colours that can be read, one hover style and one
 * focus ring. For the JavaFX thread.
 */
public final class CommonStyles {

  private CommonStyles() {}

  /** Gives them to the root of a window. */
  public static void install(Parent root) {
    root.getStylesheets().add(CommonStyles.class.getResource("common.css").toExternalForm());
  }
}
