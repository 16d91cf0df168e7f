"""Every module compiles without warnings, and is not changed by its import."""
import py_compile
import warnings

from generated import flat, functions_of, models, module_at, path_of, root

warnings.simplefilter("error")
scenes = [root / "models/scenes" / f"{name}.scene.toml" for name in ("balance", "cart_pole_prediction", "kepler_polar_routh")]

for path in [*models, *scenes]:
    written = path_of(path)
    py_compile.compile(str(written), cfile=str(written.with_suffix(".pyc")), doraise=True)
    module = module_at(written)
    assert module.__doc__ and all(each.__doc__ for each in functions_of(module)), path
    assert len(module.start_coordinates) == len(module.coordinate_names) == len(module.coordinate_ranges)
    assert len(module.parameter_names) == len(module.Parameters._fields) == len(module.parameter_units)
    assert all(isinstance(x, float) for x in flat(module.Parameters()))

print(f"{len(models) + len(scenes)} modules")
