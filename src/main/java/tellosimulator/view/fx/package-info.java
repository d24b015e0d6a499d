/**
 * Converts values of the simulator to JavaFX.
 *
 * <p>{@link tellosimulator.view.fx.FxMeshes}, {@link tellosimulator.view.fx.FxTextures} and {@link
 * tellosimulator.view.fx.FxFrames} convert meshes, textures and poses; {@link
 * tellosimulator.view.fx.ScreenPixels} shows pixels that are rendered elsewhere. Meshes can be
 * converted on any thread; everything else is confined to the JavaFX thread. {@link
 * tellosimulator.view.fx.Nodes} and {@link tellosimulator.view.fx.Tooltips} give nodes the settings
 * that most views need. The converted values come from {@code scenery} and {@code math}. The
 * package does not contain any panels.
 */
package tellosimulator.view.fx;
