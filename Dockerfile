# The project, set up, for any machine with Docker or Podman: see docs/container.md.
FROM docker.io/library/debian:12

# What neither runs nor builds a package in Python is not unpacked: documents, the headers and static
# libraries of Boost, ICU and Python, link-time optimization, sanitizers, Perl's modules (git needs none).
RUN printf 'path-exclude=%s\n' '/usr/share/doc/*' '/usr/share/man/*' '/usr/share/locale/*' \
        '/usr/include/boost/*' '/usr/include/eigen3/*' '/usr/lib/*/libboost*.a' '/usr/lib/*/libicu*.a' \
        '/usr/lib/*/libpython*.a' '/usr/lib/python3*/config-*/*.a' \
        '/usr/lib/gcc/*/lto1' '/usr/bin/*-lto-dump*' '/usr/lib/*/lib*san.*' '/usr/*gprofng*' \
        '/usr/bin/cpack' '/usr/bin/ctest' '/usr/share/perl/*' '/usr/lib/*/perl/*' \
        >/etc/dpkg/dpkg.cfg.d/odometry && \
    echo 'path-include=/usr/share/doc/*/copyright' >>/etc/dpkg/dpkg.cfg.d/odometry && \
    useradd --create-home --shell /bin/bash learner

COPY . /odometry
WORKDIR /odometry
ENV HOME=/home/learner ROS_HOME=/home/learner/.ros LANG=C.UTF-8 ODOMETRY_VIEW_HOST=0.0.0.0

# In the same layer goes what was only needed on the way: apt's lists, symbols for debuggers (nine
# tenths of PyBullet), PyBullet's models, tests. --user may name anybody, who builds here too.
RUN export PIP_NO_CACHE_DIR=1 && ./ws --set-up demo --view && ./ws --set-up sweep && \
    apt-get install -q -y --no-install-recommends ca-certificates git tini && \
    apt-get clean && rm -rf /var/lib/apt/lists/* /var/cache/debconf/*-old /var/lib/dpkg/*-old && \
    find /var/log -type f -delete && \
    find .venv -name '*.cpython-*.so' -exec strip --strip-debug {} + && \
    find .venv/lib/python3*/site-packages/pybullet_data -mindepth 2 -delete && \
    rm -rf /usr/lib/python3/dist-packages/numpy/*/tests .venv/lib/python3*/site-packages/*/tests && \
    rm -rf "$HOME/.cache" && .venv/bin/python3 -c 'import matplotlib.font_manager' && \
    .venv/bin/python3 -m compileall -q */src tools/*/src */script* tools/*/script* && \
    mkdir runs && chmod -R a+rX . && chmod a+w . && chmod -R a+w .ws .venv runs "$HOME"

USER learner
ENTRYPOINT ["tini", "--", "./ws"]
CMD ["demo", "--view"]
