/**
 * The simulator's values as JavaFX has them.
 *
 * <p>{@link tellosimulator.view.fx.FxMeshes}, {@link tellosimulator.view.fx.FxTextures} and {@link
 * tellosimulator.view.fx.FxFrames} convert meshes, textures and poses; {@link
 * tellosimulator.view.fx.ScreenPixels} shows pixels that somebody else draws. Meshes and textures
 * can be converted on any thread. {@link tellosimulator.view.fx.CommonStyles} and {@link
 * tellosimulator.view.fx.Tooltips} are what windows look like everywhere. What is converted comes
 * from {@code scenery} and {@code math}; where it is shown is not its job.
 */
package tellosimulator.view.fx;
